"""A participant's trials as they stand in the study, with the times they are expected at."""

from __future__ import annotations

from dataclasses import dataclass

from omnistudy.errors.study import UnknownParticipant
from omnistudy.protocol.schedule import expected_duration
from omnistudy.store import StudyFile
from omnistudy.study.frozen import frozen_protocol

STORED = (
    *("trial", "visit", "position", "attempt", "kind", "condition", "repetition", "route"),
    "status",
)
"""Columns of the study's trials that a plan shows."""


@dataclass(frozen=True, slots=True)
class SessionTrial:
    """One trial of a participant's plan.

    trial : its number in the study.
    condition : None as long as an order that adapts has not chosen it.
    start_s, duration_s : expected, s from the opening of the session.
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
    start_s: float
    duration_s: float


def plan_session(study: StudyFile, participant: str) -> tuple[SessionTrial, ...]:
    """Give all trials of a participant (by code) in their order; raises UnknownParticipant."""
    codes = [str(code) for code in study.participants()["participant"]]
    if participant not in codes:
        raise UnknownParticipant(study.study.name, participant, codes)
    protocol = frozen_protocol(study.study)
    attempts = study.trials()
    trials = attempts[attempts["status"] != "void"]  # each of them is followed by another attempt
    own = trials[trials["participant"] == participant].sort_values(["visit", "position", "attempt"])
    planned: list[SessionTrial] = []
    for row in own[list(STORED)].to_dict("records"):
        stored = {str(column): value for column, value in row.items()}
        before = planned[-1] if planned and planned[-1].visit == stored["visit"] else None
        start = before.start_s + before.duration_s + protocol.session.pause if before else 0.0
        duration = expected_duration(protocol, stored["condition"], stored["route"])
        planned.append(SessionTrial(**stored, start_s=start, duration_s=duration))
    return tuple(planned)
