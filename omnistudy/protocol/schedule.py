"""When a participant's trials are expected to happen."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.protocol.plan import PlannedTrial, plan
from omnistudy.protocol.protocol import Protocol


class ExpectedTrial(NamedTuple):
    """A planned trial with its time in the session.

    start_s, duration_s : expected, s from the opening of the session.
    """

    trial: PlannedTrial
    start_s: float
    duration_s: float


def expected_duration(protocol: Protocol, condition: str, route: str) -> float:
    """Say in s how long a trial is likely to take; raises UnknownRoute, UnknownCondition."""
    setup = protocol.setup_for(condition)
    return setup.task.expected_duration(setup.world, route)


def schedule(protocol: Protocol, slot: int) -> tuple[ExpectedTrial, ...]:
    """Give a slot's trials with their expected times, the planned pause between two trials."""
    start = 0.0
    expected = []
    for trial in plan(protocol, slot):
        duration = expected_duration(protocol, trial.condition, trial.route)
        expected.append(ExpectedTrial(trial, start, duration))
        start += duration + protocol.session.pause
    return tuple(expected)


def session_duration(protocol: Protocol, slot: int) -> float:
    """Say in s how long a slot's session is likely to take."""
    last = schedule(protocol, slot)[-1]
    return last.start_s + last.duration_s
