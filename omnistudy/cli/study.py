"""`omnistudy study`: a frozen protocol, and who runs it, in a database."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, ProtocolArgument, StudyArgument, protocol_names
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from pathlib import Path

    from omnistudy.protocol import Protocol

app = typer.Typer(no_args_is_help=True, help="Studies: who runs a protocol, in a database.")


@app.command()
def create(
    protocol: ProtocolArgument,
    changes: Annotated[
        list[str] | None,
        typer.Argument(metavar="[KEY=VALUE]...", help="Changes, such as participants.count=4."),
    ] = None,
    name: Annotated[
        str | None,
        typer.Option(help="Name in the folder of studies, or path of the .db."),
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would be written, and write nothing.")
    ] = False,
    json: AsJson = False,
) -> None:
    """Freeze a protocol into a new study; virtual participants are enrolled at once.

    Example: omnistudy study create utah2017_component --name first
    """
    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.store import open_study
    from omnistudy.study import create_study, new_study_file, study_status
    from omnistudy.study.create import refuse_taken

    composed = compose_protocol(protocol, changes or ())
    path = new_study_file(name or composed.name)
    if dry_run:
        refuse_taken(path, path.stem)
        _print_plan(composed, path, json)
        return
    create_study(composed, path, path.stem)
    with open_study(path) as study:
        status = study_status(study)
    if json:
        print_json(status)
        return
    planned = sum(person.planned for person in status.participants)
    print_line(
        f"created {status.kind} study '{status.name}' in {path}: "
        f"{len(status.participants)} participants, {planned} trials planned"
    )


def _print_plan(protocol: Protocol, path: Path, json: bool) -> None:
    from omnistudy.protocol import freeze, plan

    frozen = freeze(protocol)
    people = protocol.participants
    if json:
        planned = {"file": path, "kind": people.kind, "participants": people.count}
        hashes = {"design_hash": frozen.design_hash, "site_hash": frozen.site_hash}
        print_json({**planned, "trials_each": len(plan(protocol, 0)), **hashes})
        return
    print_line(
        f"would write {path}: {people.count} {people.kind} participants, "
        f"{len(plan(protocol, 0))} trials each"
    )
    print_line(f"design hash  {frozen.design_hash}\nsite hash    {frozen.site_hash}")


@app.command("list")
def list_(json: AsJson = False) -> None:
    """List the studies in the folder of studies.

    Example: omnistudy study list
    """
    from omnistudy.study import listed_studies, studies_folder

    studies = listed_studies()
    if json:
        print_json(studies)
        return
    rows = [
        (one.name, one.kind, one.participants, one.completed, one.trials, one.fault or None)
        for one in studies
    ]
    columns = ("study", "kind", "participants", "completed", "trials", "fault")
    print_table(f"Studies in {studies_folder()}", columns, rows)


@app.command()
def show(study: StudyArgument, json: AsJson = False) -> None:
    """Print the protocol that a study was frozen with, every number resolved.

    Example: omnistudy study show first
    """
    from omnistudy.cli.protocol import print_page
    from omnistudy.store import open_study
    from omnistudy.study import frozen_protocol, resolve_study

    with open_study(resolve_study(study)) as opened:
        record = opened.study
    if json:
        print_line(record.protocol_json)
    else:
        print_page(frozen_protocol(record))


@app.command()
def status(study: StudyArgument, json: AsJson = False) -> None:
    """Say how far a study is, participant by participant.

    Example: omnistudy study status first
    """
    from omnistudy.store import open_study
    from omnistudy.study import resolve_study, study_status

    with open_study(resolve_study(study)) as opened:
        found = study_status(opened)
    if json:
        print_json(found)
        return
    print_line(f"{found.title}\n")
    print_line(f"file         {found.file}")
    print_line(f"kind         {found.kind}")
    print_line(f"protocol     version {found.protocol_version}")
    print_line(f"design hash  {found.design_hash}")
    print_line(f"site hash    {found.site_hash}\n")
    rows = [
        (one.code, one.status, one.planned, one.completed, one.timed_out, one.other)
        for one in found.participants
    ]
    columns = ("participant", "status", "planned", "completed", "timed out", "other")
    print_table("Trials", columns, rows)


@app.command()
def diff(
    study: StudyArgument,
    protocol: Annotated[
        str | None,
        typer.Argument(
            help="A protocol's name or file; else the one of the frozen protocol's name.",
            autocompletion=protocol_names,
        ),
    ] = None,
    changes: Annotated[
        list[str] | None,
        typer.Argument(metavar="[KEY=VALUE]...", help="Changes that the study was made with."),
    ] = None,
) -> None:
    """Refuse a protocol that was changed after the study was frozen; exits 1 with what differs.

    Example: omnistudy study diff first utah2017_component
    """
    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.store import open_study
    from omnistudy.study import check_unchanged, frozen_protocol, resolve_study

    with open_study(resolve_study(study)) as opened:
        record = opened.study
    given = compose_protocol(protocol or frozen_protocol(record).name, changes or ())
    check_unchanged(record, given)
    print_line(f"the protocol is the one that study '{record.name}' was frozen with")


@app.command()
def amend(
    study: StudyArgument,
    protocol: ProtocolArgument,
    reason: Annotated[str, typer.Option(help="Why, for the list of the protocol's versions.")],
    changes: Annotated[
        list[str] | None,
        typer.Argument(metavar="[KEY=VALUE]...", help="Changes that the study was made with."),
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would change, and change nothing.")
    ] = False,
    json: AsJson = False,
) -> None:
    """Amend texts, site or device of a study; its design and allocation stay as they were drawn.

    Example: omnistudy study amend first mended.yaml --reason "a typing mistake in a message"
    """
    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.store import open_study
    from omnistudy.study import amend_study, amendment, resolve_study

    path, given = resolve_study(study), compose_protocol(protocol, changes or ())
    if dry_run:
        with open_study(path) as opened:
            made = amendment(opened.study, given)
    else:
        made = amend_study(path, given, reason)
    if json:
        print_json(made)
        return
    for difference in made.differences:
        print_line(str(difference))
    verb = "would become" if dry_run else "is now"
    print_line(f"the protocol of study '{made.study}' {verb} version {made.version}")


@app.command()
def upgrade(study: StudyArgument) -> None:
    """Bring the database of an older omnistudy up to date, after copying it.

    Example: omnistudy study upgrade first
    """
    from omnistudy.store import upgrade_study
    from omnistudy.study import resolve_study

    path = resolve_study(study)
    copy = upgrade_study(path)
    if copy is None:
        print_line(f"'{path}' is up to date")
    else:
        print_line(f"upgraded '{path}'; the copy of what it was is '{copy}'")
