"""Making a study: the protocol is frozen, virtual participants are enrolled at once."""

from __future__ import annotations

import re
from pathlib import Path

from omnistudy.errors.store import StudyExists
from omnistudy.errors.study import BadStudyName
from omnistudy.protocol import FrozenProtocol, Protocol, freeze, plan
from omnistudy.protocol.seeds import participant_seed, trial_seed
from omnistudy.store import (
    Level,
    NewCondition,
    NewParticipant,
    NewStudy,
    NewTrial,
    StudyRecord,
    StudyWriter,
    open_study,
)

FIRST_VERSION = 1
FIRST_OCCUPANT = 1
FIRST_ATTEMPT = 1


def create_study(protocol: Protocol, path: Path, name: str) -> StudyRecord:
    """Freeze a protocol into a new database, with all that is planned; whole or not at all.

    Raises StudyExists, BadStudyName, NotWritable or StoreFull.
    """
    refuse_taken(path, name)
    frozen = freeze(protocol)
    study = NewStudy(
        name=name,
        title=protocol.title,
        kind=protocol.participants.kind,
        protocol_json=frozen.canonical_json,
        protocol_version=FIRST_VERSION,
        design_hash=frozen.design_hash,
        site_hash=frozen.site_hash,
    )
    with StudyWriter.create(path, study) as writer:
        writer.add_conditions(_conditions(protocol))
        if protocol.participants.kind == "virtual":
            for slot in range(protocol.participants.count):
                _enrol(writer, protocol, frozen, slot)
    with open_study(path) as created:
        return created.study


def refuse_taken(path: Path, name: str) -> None:
    """Raise StudyExists for a file that is there, BadStudyName for a name that no file can have."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", name):
        raise BadStudyName(name)
    if path.exists():
        raise StudyExists(path)


def _conditions(protocol: Protocol) -> tuple[NewCondition, ...]:
    return tuple(
        NewCondition(
            name=condition.name,
            masked_label=condition.masked_label,
            levels=tuple(Level(level.factor, level.level) for level in condition.levels),
        )
        for condition in protocol.conditions
    )


def _enrol(writer: StudyWriter, protocol: Protocol, frozen: FrozenProtocol, slot: int) -> None:
    """Write a virtual participant with one visit and every trial of the slot's order."""
    people = protocol.participants
    participant = writer.add_participant(
        NewParticipant(
            code=f"P{slot + 1:02d}",
            kind="virtual",
            sequence=str(slot),
            seed=participant_seed(people.participant_key, slot, FIRST_OCCUPANT),
        )
    )
    session = writer.add_session(participant, visit=1)
    for trial in plan(protocol, slot):
        seed = trial_seed(
            frozen.design_hash,
            people.study_key,
            slot,
            FIRST_OCCUPANT,
            trial.position,
            FIRST_ATTEMPT,
        )
        writer.add_trial(
            NewTrial(
                session_id=session,
                position=trial.position,
                attempt=FIRST_ATTEMPT,
                kind=trial.kind,
                condition=trial.condition,
                repetition=trial.repetition,
                task=protocol.setup_for(trial.condition).task.kind,
                route=trial.route,
                seed=seed,
                protocol_version=FIRST_VERSION,
            )
        )
