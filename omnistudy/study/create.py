"""Making a study: the protocol is frozen, virtual participants are enrolled at once."""

from __future__ import annotations

import re
from pathlib import Path

from omnistudy.errors.store import StudyExists
from omnistudy.errors.study import BadStudyName
from omnistudy.protocol import FrozenProtocol, Protocol, StudyPlan, freeze
from omnistudy.protocol.allocation import Allocation
from omnistudy.protocol.seeds import participant_seed, trial_seed
from omnistudy.store import (
    Level,
    NewAllocation,
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
    plan = StudyPlan(protocol, frozen.design_hash)
    with StudyWriter.create(path, study) as writer:
        writer.add_conditions(new_conditions(protocol))
        writer.add_allocations(NewAllocation(*slot) for slot in plan.allocations)
        if protocol.participants.kind == "virtual":
            for allocation in plan.allocations:
                _enrol(writer, protocol, frozen, plan, allocation)
    with open_study(path) as created:
        return created.study


def refuse_taken(path: Path, name: str) -> None:
    """Raise StudyExists for a file that is there, BadStudyName for a name that no file can have."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", name):
        raise BadStudyName(name)
    if path.exists():
        raise StudyExists(path)


def new_conditions(protocol: Protocol) -> tuple[NewCondition, ...]:
    """Give the conditions as the store wants them."""
    return tuple(
        NewCondition(
            name=condition.name,
            masked_label=condition.masked_label,
            levels=tuple(Level(level.factor, level.level) for level in condition.levels),
        )
        for condition in protocol.conditions
    )


def _enrol(
    writer: StudyWriter,
    protocol: Protocol,
    frozen: FrozenProtocol,
    plan: StudyPlan,
    allocation: Allocation,
) -> None:
    """Write a virtual participant with every visit and every trial of the slot's order."""
    people, slot = protocol.participants, allocation.slot
    participant = writer.add_participant(
        NewParticipant(
            code=f"P{slot + 1:02d}",
            kind="virtual",
            group_name=allocation.group or None,
            sequence=str(allocation.row),
            seed=participant_seed(people.participant_key, slot, FIRST_OCCUPANT),
        ),
        slot,
    )
    sessions = {
        visit: writer.add_session(participant, visit)
        for visit in range(1, len(protocol.course) + 1)
    }
    for trial in plan.trials(slot):
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
                session_id=sessions[trial.visit],
                position=trial.position,
                attempt=FIRST_ATTEMPT,
                kind=trial.kind,
                condition=trial.condition,
                repetition=trial.repetition,
                task=_task(protocol, trial.condition),
                route=trial.route,
                seed=seed,
                protocol_version=FIRST_VERSION,
            )
        )


def _task(protocol: Protocol, condition: str | None) -> str:
    setup = protocol if condition is None else protocol.setup_for(condition)
    return setup.task.kind
