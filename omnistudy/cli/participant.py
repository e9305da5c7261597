"""`omnistudy participant`: who takes part in a study."""

from __future__ import annotations

import typer

from omnistudy.cli.arguments import AsJson, ParticipantArgument, StudyArgument
from omnistudy.cli.output import print_json, print_line, print_table

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


@app.command()
def show(
    study: StudyArgument,
    participant: ParticipantArgument,
    json: AsJson = False,
) -> None:
    """Show a participant and what became of each trial.

    Example: omnistudy participant show first P01
    """
    from omnistudy.store import open_study
    from omnistudy.study import resolve_study
    from omnistudy.study.participant import participant_record

    with open_study(resolve_study(study)) as opened:
        found = participant_record(opened, participant)
    if json:
        print_json(found)
        return
    group = f", group {found.group}" if found.group else ""
    print_line(f"{found.code}: {found.kind}, {found.status}, slot {found.sequence}{group}")
    rows = [
        (
            trial.position,
            trial.attempt,
            trial.condition,
            trial.repetition,
            trial.route,
            trial.status,
            trial.duration_s,
            trial.collisions,
            trial.reason or None,
        )
        for trial in found.trials
    ]
    columns = ("position", "attempt", "condition", "repetition", "route", "status", "duration in s",
               "collisions", "reason")  # fmt: skip
    print_table("Trials", columns, rows)
