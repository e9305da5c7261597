"""Seeds of a study: of its allocation, of a virtual person, of a trial's attempt.

A seed is 64 hex digits of SHA-256 over what identifies the thing, so that it can be made again from
the frozen protocol and the study key alone.
"""

from __future__ import annotations

from omnistudy.seeds import seed_text


def allocation_seed(design_hash: str, study_key: str) -> str:
    """Give the seed behind groups, orders and routes: it knows no participant."""
    return seed_text("allocation", design_hash, study_key)


def participant_seed(participant_key: str, slot: int, occupant: int) -> str:
    """Give the seed of a virtual person.

    The design is left out on purpose: protocols that share the key meet the same people, so that
    a curve over their arms and the main study speak of the same participants.
    """
    return seed_text("participant", participant_key, slot, occupant)


def trial_seed(
    design_hash: str, study_key: str, slot: int, occupant: int, position: int, attempt: int
) -> str:
    """Give the seed of one attempt at one trial; `position` and `attempt` count from 1."""
    return seed_text(design_hash, study_key, slot, occupant, position, attempt)
