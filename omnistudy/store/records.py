"""What goes into a study database and comes out of it, as frozen values."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from typing import Literal, NamedTuple

ParticipantKind = Literal["virtual", "human"]
ParticipantStatus = Literal["enrolled", "active", "completed", "withdrawn"]
SessionStatus = Literal["planned", "running", "completed", "aborted"]
TrialStatus = Literal["planned", "running", "completed", "timed_out", "void", "aborted"]
EndStatus = Literal["completed", "timed_out", "void", "aborted"]


class Level(NamedTuple):
    """The level that a condition has on one factor of the design."""

    factor: str
    level: str


@dataclass(frozen=True, slots=True, kw_only=True)
class NewStudy:
    """A frozen protocol that becomes a study.

    protocol_json : canonical JSON text of the protocol.
    design_hash, site_hash : 64 hex digits of SHA-256.
    """

    name: str
    title: str
    kind: ParticipantKind
    protocol_json: str
    protocol_version: int
    design_hash: str
    site_hash: str


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyRecord(NewStudy):
    """The study as stored: with the time of its making (UTC) and the omnistudy that made it."""

    created_at: datetime
    omnistudy_version: str


@dataclass(frozen=True, slots=True, kw_only=True)
class NewCondition:
    """A condition, the label that hides it from a blinded analyst, and its levels."""

    name: str
    masked_label: str
    levels: tuple[Level, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class NewParticipant:
    """Somebody who takes part; `seed` is 64 hex digits."""

    code: str
    kind: ParticipantKind
    seed: str
    group_name: str | None = None
    sequence: str | None = None
    status: ParticipantStatus = "enrolled"


class NewAllocation(NamedTuple):
    """A slot of the design, see omnistudy.protocol.allocation.Allocation; nobody sits in it yet."""

    slot: int
    stratum: str
    group: str
    row: int


@dataclass(frozen=True, slots=True, kw_only=True)
class ProtocolVersion:
    """A protocol as it was frozen: the first (version 1), and every amendment with its reason."""

    version: int
    protocol_json: str
    design_hash: str
    site_hash: str
    reason: str
    frozen_at: datetime
    omnistudy_version: str


@dataclass(frozen=True, slots=True, kw_only=True)
class NewTrial:
    """A trial to be run: the place in its session, what is driven, and its seed (64 hex digits).

    position : 1-based place in the participant's order, counted through all visits; a repeated
        trial keeps it and counts `attempt` up.
    kind : what the trial is for, such as "practice" or "main".
    condition : None as long as an order that adapts has not chosen it.
    """

    session_id: int
    position: int
    kind: str
    task: str
    route: str
    seed: str
    condition: str | None = None
    repetition: int = 1
    protocol_version: int = 1
    attempt: int = 1
    reason: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class StoredTrial(NewTrial):
    """A trial as stored, with who drives it: all that a session needs to run it.

    slot : 0-based, where the participant sits in the design.
    duration_s, collisions : None until it is run.
    """

    id: int
    status: TrialStatus
    visit: int
    participant_id: int
    participant_code: str
    participant_kind: ParticipantKind
    participant_seed: str
    slot: int
    duration_s: float | None
    collisions: int | None


@dataclass(frozen=True, slots=True, kw_only=True)
class TrialOutcome:
    """What one attempt came to; NaN (stored as NULL) where a quantity does not exist.

    duration_s : s from the event `start` to the end.
    collisions : debounced; collisions_legacy : rising edges, as published.
    """

    status: EndStatus
    reason: str
    duration_s: float
    path_length_m: float
    collisions: int
    collisions_legacy: int
    contact_time_s: float
