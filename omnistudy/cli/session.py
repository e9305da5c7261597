"""`omnistudy session`: a participant's trials, planned and run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import (
    AsJson,
    ParticipantArgument,
    StudyArgument,
    Workers,
    participant_codes,
)
from omnistudy.cli.output import print_json, print_line, print_table, progress

if TYPE_CHECKING:
    from pathlib import Path

    from omnistudy.session import RunSummary

app = typer.Typer(no_args_is_help=True, help="A participant's trials: plan them, run them.")


def _clock(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


@app.command()
def plan(
    study: StudyArgument,
    participant: ParticipantArgument,
    json: AsJson = False,
) -> None:
    """Print a participant's trials in their order, with the times they are expected at.

    Example: omnistudy session plan first P01
    """
    from omnistudy.store import open_study
    from omnistudy.study import plan_session, resolve_study

    with open_study(resolve_study(study)) as opened:
        trials = plan_session(opened, participant)
        name = opened.study.name
    if json:
        print_json(trials)
        return
    print_table(
        f"Session of {participant} in '{name}' (minutes:seconds, expected)",
        (
            "visit",
            "starts",
            "lasts",
            "position",
            "kind",
            "condition",
            "repetition",
            "route",
            "status",
        ),
        [
            (
                trial.visit,
                _clock(trial.start_s),
                _clock(trial.duration_s),
                trial.position,
                trial.kind,
                trial.condition,
                trial.repetition,
                trial.route,
                trial.status,
            )
            for trial in trials
        ],
    )


@app.command()
def run(
    study: StudyArgument,
    participant: Annotated[
        list[str] | None,
        typer.Argument(
            help="Codes; every participant unless given.", autocompletion=participant_codes
        ),
    ] = None,
    trials: Annotated[
        int | None, typer.Option(min=1, help="Stop after so many trials; the rest stays planned.")
    ] = None,
    workers: Workers = None,
    protocol: Annotated[
        str | None,
        typer.Option(help="Protocol that the study must have been frozen with, by name or file."),
    ] = None,
    live: Annotated[
        bool,
        typer.Option("--live", help="One trial at a time, in real time, to be seen in browsers."),
    ] = False,
    open_browser: Annotated[
        bool, typer.Option("--open/--no-open", help="Open the live pages in the browser.")
    ] = True,
    pauses: Annotated[
        bool,
        typer.Option(
            "--pauses/--no-pauses",
            help="Show instructions, countdown and rests between live trials.",
        ),
    ] = True,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say how many trials would run, and run none.")
    ] = False,
    json: AsJson = False,
) -> None:
    """Run what is planned; a stopped run goes on where it was.

    Example: omnistudy session run first P01 --trials 2
    """
    from omnistudy.study import resolve_study

    path = resolve_study(study)
    codes = tuple(participant or ())
    waiting = count_waiting(path, codes, trials)
    if dry_run:
        print_line(f"{waiting} trials would run")
        return
    if live:
        from omnistudy.cli.live_run import run_with_pages

        with progress(f"running {path.stem}", waiting) as advance:
            summary = run_with_pages(
                path,
                participants=codes,
                limit=trials,
                protocol=protocol,
                open_browser=open_browser,
                pauses=pauses,
                finished=advance,
            )
    else:
        summary = run_with_progress(path, waiting, codes, trials, workers, protocol)
    if json:
        print_json(summary)
        return
    print_line(
        f"{summary.completed} trials completed, {summary.timed_out} timed out, "
        f"{summary.void} void, {summary.aborted} aborted; {summary.remaining} still planned"
    )


def count_waiting(path: Path, participants: tuple[str, ...], limit: int | None) -> int:
    """Count the trials that a run would drive."""
    from omnistudy.store import open_study

    with open_study(path) as opened:
        trials = opened.trials()
    waiting = trials[trials["status"].isin(["planned", "running"])]
    if participants:
        waiting = waiting[waiting["participant"].isin(participants)]
    return len(waiting) if limit is None else min(limit, len(waiting))


def run_with_progress(
    path: Path,
    waiting: int,
    participants: tuple[str, ...] = (),
    limit: int | None = None,
    workers: int | None = None,
    protocol: str | None = None,
) -> RunSummary:
    """Run the planned trials of a study behind a progress bar."""
    import os

    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.session import run_trials

    with progress(f"running {path.stem}", waiting) as advance:
        return run_trials(
            path,
            participants=participants,
            limit=limit,
            workers=min(workers or os.cpu_count() or 1, max(1, waiting)),
            protocol=compose_protocol(protocol) if protocol else None,
            finished=lambda trial, result: advance(),
        )
