"""A virtual participant's trials without a study: nothing is stored."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from omnistudy.operators import Person
from omnistudy.protocol import Protocol
from omnistudy.protocol.seeds import participant_seed
from omnistudy.seeds import seed_text
from omnistudy.session.specs import coupled
from omnistudy.session.workers import run_all
from omnistudy.trial import TrialResult
from omnistudy.worlds import World


@dataclass(frozen=True, slots=True)
class Rehearsed:
    """One trial that was driven, in which condition and world."""

    condition: str
    world: World
    result: TrialResult


def rehearse(protocol: Protocol, conditions: Sequence[str], slot: int = 0) -> tuple[Rehearsed, ...]:
    """Drive the protocol's first route once in each condition, one process a condition.

    The person is the one of the slot in a virtual study; all conditions meet the same noise.
    Raises UnknownCondition.
    """
    key = protocol.participants.participant_key
    person = Person(participant_seed(key, slot, 1), seed_text("rehearsal", key, slot), 1)
    specs = [coupled(protocol, condition, protocol.routes[0], person) for condition in conditions]
    results = run_all(specs, workers=len(specs))
    return tuple(
        Rehearsed(condition, spec.world, result)
        for condition, spec, result in zip(conditions, specs, results, strict=True)
    )
