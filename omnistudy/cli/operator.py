"""`omnistudy operator`: who holds the stick, and how virtual people are calibrated."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, Workers
from omnistudy.cli.kind_verbs import add_list_and_show
from omnistudy.cli.output import print_json, print_line, print_table, progress

if TYPE_CHECKING:
    from omnistudy.session.calibrate import Calibration

app = typer.Typer(no_args_is_help=True)
add_list_and_show(app, "operator", "virtual_driver")

SKILLS = (0.75, 1.25, 1.75, 2.25, 2.75, 3.5, 4.5, 6.0)
"""Skills at which the response is measured; 0 is perfect."""


@app.command()
def calibrate(
    protocol: Annotated[str, typer.Argument(help="Protocol with a no-feedback condition.")] = (
        "utah2017_component"
    ),
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="YAML page to write the result to.")
    ] = None,
    mean: Annotated[
        float, typer.Option(help="No-feedback collisions a trial, counted as published.")
    ] = 34.0,
    best: Annotated[float, typer.Option(help="Those of the best of eight people.")] = 17.0,
    worst: Annotated[float, typer.Option(help="Those of the worst of eight people.")] = 83.0,
    each: Annotated[int, typer.Option(min=3, help="Trials at each skill.")] = 9,
    check: Annotated[int, typer.Option(min=6, help="Fresh trials that check the result.")] = 36,
    seed: Annotated[str, typer.Option(help="Text from which every draw is made.")] = "calibrate",
    workers: Workers = None,
    json: AsJson = False,
) -> None:
    """Find the virtual driver's skill from no-feedback trials alone.

    Collisions are counted as the thesis's code does (the column collisions_legacy).

    Example: omnistudy operator calibrate utah2017_component -o virtual_driver.yaml
    """
    import os

    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.session.calibrate import calibrate as find
    from omnistudy.session.calibrate import trials_needed
    from omnistudy.session.population import Targets

    if output is not None and output.exists():
        raise typer.BadParameter(f"{output} exists; choose another name or remove it")
    total = trials_needed(SKILLS, each, check)
    with progress("calibrating on no-feedback trials", total) as advance:
        found = find(
            compose_protocol(protocol),
            Targets(mean, best, worst),
            skills=SKILLS,
            each=each,
            check=check,
            seed=seed,
            workers=workers or os.cpu_count() or 1,
            driven=advance,
        )
    page = _page(found, protocol, seed)
    if output is not None:
        output.write_text(page, encoding="utf-8")
    if json:
        print_json(found)
        return
    print_table(
        "No-feedback collisions by skill",
        ("skill", "collisions a trial", "trials"),
        [(point.skill, round(point.collisions, 1), point.trials) for point in found.response],
    )
    print_line(
        f"Checked with {found.checked_trials} fresh trials: {found.checked_mean:.1f} collisions a "
        f"trial (target {found.targets.mean:g})"
    )
    print_line(page.rstrip() if output is None else f"Wrote {output}")


def _page(found: Calibration, protocol: str, seed: str) -> str:
    """Give the page of conf/operator/ that holds the result and how it came about."""
    targets = found.targets
    trials = sum(point.trials for point in found.response)
    return (
        "# Calibrated on trials without feedback alone, then frozen:\n"
        f"#   omnistudy operator calibrate {protocol} --seed {seed}\n"
        f"# Targets (Tyagi 2017, sec. 5.1, without feedback): mean {targets.mean:g}, best of eight "
        f"{targets.best:g},\n"
        f"# worst of eight {targets.worst:g} collisions, counted as published. Response from\n"
        f"# {trials} trials; {found.checked_trials} fresh trials gave {found.checked_mean:.1f}.\n"
        "kind: virtual_driver\n"
        f"skill_median: {found.skill_median}\n"
        f"skill_spread: {found.skill_spread}\n"
    )
