"""One participant of a study: who it is, and what became of each trial."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import Any

from pandas import isna

from omnistudy.errors.study import UnknownParticipant
from omnistudy.store import StudyFile

STORED = (
    "trial",
    "visit",
    "position",
    "attempt",
    "kind",
    "condition",
    "repetition",
    "route",
    "status",
    "reason",
    "duration_s",
    "collisions",
)
"""Columns of the study's trials that are told."""


@dataclass(frozen=True, slots=True)
class TrialOutcome:
    """One attempt at a trial.

    trial : its number in the study. position : 1-based place in the participant's order.
    condition : None as long as an order that adapts has not chosen it.
    reason : why it ended as it did; "" for nothing to say.
    duration_s, collisions : None before it has been driven.
    """

    trial: int
    visit: int
    position: int
    attempt: int
    kind: str
    condition: str | None
    repetition: int
    route: str
    status: str
    reason: str
    duration_s: float | None
    collisions: int | None


@dataclass(frozen=True, slots=True)
class ParticipantRecord:
    """A participant and all its trials in their order.

    sequence : the slot of the design. group : None where the design has no groups.
    seed : behind the draws that make a virtual person.
    """

    code: str
    kind: str
    group: str | None
    sequence: str
    status: str
    seed: str
    trials: tuple[TrialOutcome, ...]


def participant_record(study: StudyFile, code: str) -> ParticipantRecord:
    """Give a participant by code; raises UnknownParticipant."""
    people = {row["participant"]: row for row in study.participants().to_dict("records")}
    if code not in people:
        raise UnknownParticipant(study.study.name, code, list(people))
    person = people[code]
    trials = study.trials()
    own = trials[trials["participant"] == code].sort_values(["visit", "position", "attempt"])
    return ParticipantRecord(
        code=code,
        kind=person["kind"],
        group=_known(person["group"]),
        sequence=person["sequence"],
        status=person["status"],
        seed=person["seed"],
        trials=tuple(_outcome(row) for row in own[list(STORED)].to_dict("records")),
    )


def _outcome(row: dict[Hashable, Any]) -> TrialOutcome:
    told = {str(column): _known(value) for column, value in row.items()}
    counted = told["collisions"]
    return TrialOutcome(**told | {"collisions": None if counted is None else int(counted)})


def _known(value: Any) -> Any:
    """Give None for what a frame holds as not stored yet."""
    return None if isna(value) else value
