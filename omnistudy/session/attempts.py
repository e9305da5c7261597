"""Another attempt at a trial that has no result."""

from __future__ import annotations

from omnistudy.protocol import Protocol
from omnistudy.protocol.seeds import trial_seed
from omnistudy.store import StoredTrial, StudyWriter
from omnistudy.study.create import FIRST_OCCUPANT


def next_attempt(
    writer: StudyWriter, protocol: Protocol, trial: StoredTrial, cause: str
) -> StoredTrial:
    """Plan the next attempt at a void trial, in its place and with a seed of its own."""
    seed = trial_seed(
        writer.study.design_hash,
        protocol.participants.study_key,
        trial.slot,
        FIRST_OCCUPANT,
        trial.position,
        trial.attempt + 1,
    )
    reason = f"attempt {trial.attempt} was void: {cause}"
    planned_id = writer.add_attempt(trial.id, seed, reason)
    own = writer.planned_trials(trial.participant_code)
    (planned,) = (one for one in own if one.id == planned_id)
    return planned
