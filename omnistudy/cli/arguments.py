"""Arguments and options that several verbs share, each with its completion."""

from __future__ import annotations

from typing import Annotated

import typer


def study_names() -> list[str]:
    """Complete a study's name."""
    from omnistudy.study import study_files

    return sorted(study_files())


def participant_codes(context: typer.Context) -> list[str]:
    """Complete a participant's code in the study that stands before it on the line."""
    from omnistudy.errors import OmnistudyError
    from omnistudy.store import open_study
    from omnistudy.study import resolve_study

    try:
        with open_study(resolve_study(context.params["study"])) as study:
            return [str(code) for code in study.participants()["participant"]]
    except OmnistudyError:
        return []  # a half-typed line names no study yet


def protocol_names() -> list[str]:
    """Complete a protocol's name."""
    from omnistudy.protocol.compose import protocol_pages

    return sorted(protocol_pages())


StudyArgument = Annotated[
    str, typer.Argument(help="A study's name or the path of its .db.", autocompletion=study_names)
]
ParticipantArgument = Annotated[
    str,
    typer.Argument(help="Code of a participant, such as P01.", autocompletion=participant_codes),
]
ProtocolArgument = Annotated[
    str,
    typer.Argument(help="A protocol's name or its YAML file.", autocompletion=protocol_names),
]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]
Workers = Annotated[
    int | None, typer.Option(min=1, help="Processes; as many as there are cores unless given.")
]
Unmask = Annotated[
    bool,
    typer.Option("--unmask", help="Name conditions, in place of the labels that mask them."),
]
