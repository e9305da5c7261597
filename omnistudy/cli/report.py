"""`omnistudy report`: a study's numbers and figures as one page."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, StudyArgument
from omnistudy.cli.output import print_json, print_line, progress

if TYPE_CHECKING:
    from omnistudy.analysis.report import Report

app = typer.Typer(add_completion=False)

ARMS = "utah2017_arm_stiffness"
"""Name of the study over the prior of arm stiffness that may lie beside a study."""


@app.command()
def report(
    study: StudyArgument,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="The page; beside the study unless given."),
    ] = None,
    arm_study: Annotated[
        str | None,
        typer.Option(
            help="A study made from utah2017_arm_stiffness: numbers with feedback over its prior."
        ),
    ] = None,
    json: AsJson = False,
) -> None:
    """Write a study's report as one HTML file; an older report there is replaced.

    Example: omnistudy report first -o first.html
    """
    from omnistudy.report.write import STEPS, write_report
    from omnistudy.study import resolve_study

    path = resolve_study(study)
    arms = resolve_study(arm_study) if arm_study else None
    page = output or path.with_suffix(".html")
    with progress(f"report of {path.stem}", STEPS) as advance:
        made = write_report(path, page, arms, done=advance)
    if made.comparison and arms is None:
        _say_how_to_add_arms(path)
    if json:
        print_json({"page": page, **_numbers(made)})
        return
    print_line(str(page))


def _say_how_to_add_arms(study: Path) -> None:
    beside = study.with_name(f"{ARMS}.db")
    if beside.exists():
        print(
            f"{beside} was not used: add it with `--arm-study {beside}`, then the numbers with "
            "feedback are intervals over the arm-stiffness prior",
            file=sys.stderr,
        )


def _numbers(made: Report) -> dict[str, object]:
    """Give every number of the report but the samples behind wrenches and paths."""
    return {
        "study": made.study,
        "attempts": made.attempts,
        "collisions": made.collisions,
        "collisions_debounced": made.collisions_debounced,
        "times": made.times,
        "events": made.events,
        "collisions_by_label": made.collisions_by_label,
        "times_by_label": made.times_by_label,
        "best": made.best,
        "worst": made.worst,
        "comparison": made.comparison,
        "arm_stiffness": made.arm_stiffness,
    }
