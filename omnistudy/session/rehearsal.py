"""A virtual participant's trials without a study: nothing is stored."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from omnistudy.operators import Person
from omnistudy.protocol import Protocol
from omnistudy.protocol.seeds import participant_seed
from omnistudy.seeds import seed_text
from omnistudy.session.workers import run_all
from omnistudy.trial import TrialResult, TrialSpec
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
    specs = []
    for condition in conditions:
        setup = protocol.setup_for(condition)
        specs.append(
            TrialSpec(
                world=setup.world,
                route=protocol.routes[0],
                plant=setup.plant,
                device=setup.device,
                controller=setup.controller,
                law=setup.law,
                operator=setup.operator,
                task=setup.task,
                recording=setup.recording,
                messages=protocol.messages,
                person=person,
            )
        )
    results = run_all(specs, workers=len(specs))
    return tuple(
        Rehearsed(condition, spec.world, result)
        for condition, spec, result in zip(conditions, specs, results, strict=True)
    )
