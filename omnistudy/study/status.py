"""How far a study is."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from omnistudy.errors import OmnistudyError
from omnistudy.store import StudyFile, open_study
from omnistudy.study.find import study_files


@dataclass(frozen=True, slots=True)
class ParticipantStatus:
    """One participant: how many trials have which status."""

    code: str
    kind: str
    sequence: str
    status: str
    planned: int
    completed: int
    timed_out: int
    other: int


@dataclass(frozen=True, slots=True)
class StudyStatus:
    """A study and everybody in it; `kind` is virtual or human."""

    name: str
    title: str
    kind: str
    file: str
    protocol_version: int
    design_hash: str
    site_hash: str
    participants: tuple[ParticipantStatus, ...]


@dataclass(frozen=True, slots=True)
class ListedStudy:
    """One line of a list of studies; `fault` says why a file cannot be read."""

    name: str
    kind: str
    participants: int
    completed: int
    trials: int
    fault: str = ""


def study_status(study: StudyFile) -> StudyStatus:
    """Count a study's trials, participant by participant."""
    record = study.study
    return StudyStatus(
        name=record.name,
        title=record.title,
        kind=record.kind,
        file=str(study.path),
        protocol_version=record.protocol_version,
        design_hash=record.design_hash,
        site_hash=record.site_hash,
        participants=participants_status(study),
    )


def participants_status(study: StudyFile) -> tuple[ParticipantStatus, ...]:
    """Count each participant's trials, in the order of enrolment."""
    attempts = study.trials()
    trials = attempts[attempts["status"] != "void"]  # each of them is followed by another attempt
    counted = []
    for row in study.participants().to_dict("records"):
        statuses = trials[trials["participant"] == row["participant"]]["status"]
        counts = {name: int((statuses == name).sum()) for name in COUNTED}
        counted.append(
            ParticipantStatus(
                code=row["participant"],
                kind=row["kind"],
                sequence=row["sequence"],
                status=row["status"],
                **counts,
                other=len(statuses) - sum(counts.values()),
            )
        )
    return tuple(counted)


COUNTED = ("planned", "completed", "timed_out")
"""Statuses of trials with a column of their own."""


def listed_studies() -> tuple[ListedStudy, ...]:
    """List the studies in the folder of studies, those that cannot be read too."""
    return tuple(_listed(name, path) for name, path in study_files().items())


def _listed(name: str, path: Path) -> ListedStudy:
    try:
        with open_study(path) as study:
            status = study_status(study)
    except OmnistudyError as fault:
        return ListedStudy(name, "-", 0, 0, 0, str(fault))
    people = status.participants
    completed = sum(person.completed for person in people)
    trials = sum(
        person.planned + person.completed + person.timed_out + person.other for person in people
    )
    return ListedStudy(name, status.kind, len(people), completed, trials)
