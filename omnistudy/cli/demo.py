"""`omnistudy demo`: the published study with virtual participants, from nothing to the report."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, Workers
from omnistudy.cli.output import print_json, print_line

if TYPE_CHECKING:
    from pathlib import Path

app = typer.Typer(add_completion=False)

STUDY = "utah2017_component"
ARMS = "utah2017_arm_stiffness"
"""The with-feedback condition over the prior of arm stiffness: its predictions are intervals."""


@app.command()
def demo(
    quick: Annotated[
        bool, typer.Option("--quick", help="One route without and with feedback, drawn.")
    ] = False,
    workers: Workers = None,
    json: AsJson = False,
) -> None:
    """Run the published study with eight virtual participants and write its report.

    A stopped demo goes on where it was. Example: omnistudy demo --quick
    """
    from omnistudy.study.find import studies_folder

    folder = studies_folder()
    folder.mkdir(parents=True, exist_ok=True)
    if quick:
        _quick(folder / "demo_quick.png", json)
        return
    study, arms = (_ran(name, workers) for name in (STUDY, ARMS))
    page = _report(study, arms)
    if json:
        print_json({"study": study, "arm_study": arms, "report": page})
        return
    print_line(f"study database  {study}")
    print_line(f"report          {page}")
    print_line(f"next: open the report in a browser, or try `omnistudy study status {STUDY}`")


def _ran(name: str, workers: int | None) -> Path:
    """Create a study unless it is there, run what is still planned, give its file."""
    from omnistudy.cli.session import count_waiting, run_with_progress
    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.study import create_study, new_study_file

    path = new_study_file(name)
    if not path.exists():
        create_study(compose_protocol(name), path, name)
    waiting = count_waiting(path, (), None)
    if waiting:
        run_with_progress(path, waiting, workers=workers, protocol=name)
    return path


def _report(study: Path, arms: Path) -> Path:
    from omnistudy.report.write import write_report

    page = study.with_suffix(".html")
    write_report(study, page, arms)
    return page


def _quick(picture: Path, json: bool) -> None:
    """Drive one virtual participant's route with and without feedback, and draw both."""
    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.report.quick import draw_trials
    from omnistudy.session.rehearsal import rehearse

    driven = rehearse(compose_protocol(STUDY), ("none", "full"))
    draw_trials(driven, picture)
    rows = [
        {
            "condition": one.condition,
            "status": one.result.status,
            "duration_s": one.result.duration_s,
            "collisions": one.result.collisions,
        }
        for one in driven
    ]
    if json:
        print_json({"picture": picture, "trials": rows})
        return
    for one in driven:
        result = one.result
        print_line(
            f"{one.condition}: {result.status} in {result.duration_s:.0f} s, "
            f"{result.collisions} collisions (virtual participant)"
        )
    print_line(f"picture: {picture}")
