"""`omnistudy participant`: who takes part in a study."""

from __future__ import annotations

import typer

from omnistudy.cli.arguments import AsJson, StudyArgument
from omnistudy.cli.output import print_json, print_table

app = typer.Typer(no_args_is_help=True, help="Participants of a study.")


@app.command("list")
def list_(
    study: StudyArgument,
    json: AsJson = False,
) -> None:
    """List the participants of a study.

    Example: omnistudy participant list first
    """
    from omnistudy.store import open_study
    from omnistudy.study import participants_status, resolve_study

    with open_study(resolve_study(study)) as opened:
        people = participants_status(opened)
        name = opened.study.name
    if json:
        print_json(people)
        return
    rows = [(one.code, one.kind, one.sequence, one.status, one.completed) for one in people]
    columns = ("participant", "kind", "slot", "status", "trials completed")
    print_table(f"Participants of {name}", columns, rows)
