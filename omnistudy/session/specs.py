"""From a protocol's condition to the value that decides a trial."""

from __future__ import annotations

from omnistudy.operators import Operator, Person
from omnistudy.protocol import Protocol
from omnistudy.store import StoredTrial
from omnistudy.trial import TrialSpec


def coupled(
    protocol: Protocol, condition: str, route: str, person: Person, operator: Operator | None = None
) -> TrialSpec:
    """Couple a condition's parts for one person on one route.

    operator : instead of the condition's own. Raises UnknownCondition or UnknownRoute.
    """
    setup = protocol.setup_for(condition)
    setup.world.route(route)
    return TrialSpec(
        world=setup.world,
        route=route,
        plant=setup.plant,
        device=setup.device,
        controller=setup.controller,
        law=setup.law,
        operator=operator or setup.operator,
        task=setup.task,
        recording=setup.recording,
        messages=protocol.messages,
        person=person,
    )


def trial_spec(protocol: Protocol, trial: StoredTrial) -> TrialSpec:
    """Give the spec of a stored trial; raises UnknownCondition or UnknownRoute."""
    person = Person(trial.participant_seed, trial.seed, trial.position)
    return coupled(protocol, trial.condition or "", trial.route, person)
