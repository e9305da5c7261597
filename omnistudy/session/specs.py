"""From a planned trial in the store to the value that decides it."""

from __future__ import annotations

from omnistudy.operators import Person
from omnistudy.protocol import Protocol
from omnistudy.store import StoredTrial
from omnistudy.trial import TrialSpec


def trial_spec(protocol: Protocol, trial: StoredTrial) -> TrialSpec:
    """Couple the condition's parts with the participant's seeds.

    Raises UnknownCondition or UnknownRoute when the protocol is not the trial's own.
    """
    setup = protocol.setup_for(trial.condition or "")
    setup.world.route(trial.route)
    return TrialSpec(
        world=setup.world,
        route=trial.route,
        plant=setup.plant,
        device=setup.device,
        controller=setup.controller,
        law=setup.law,
        operator=setup.operator,
        task=setup.task,
        recording=setup.recording,
        messages=protocol.messages,
        person=Person(trial.participant_seed, trial.seed, trial.position),
    )
