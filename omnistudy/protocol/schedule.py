"""When a participant's trials are expected to happen."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.protocol.plan import PlannedTrial, StudyPlan
from omnistudy.protocol.protocol import Protocol


class ExpectedTrial(NamedTuple):
    """A planned trial with its time in the visit.

    start_s, duration_s : expected, s from the opening of the visit.
    """

    trial: PlannedTrial
    start_s: float
    duration_s: float


def expected_duration(protocol: Protocol, condition: str | None, route: str) -> float:
    """Say in s how long a trial is likely to take; raises UnknownRoute, UnknownCondition.

    A trial whose condition is still to be chosen is expected to take as long as in the first.
    """
    setup = protocol.setup_for(condition or protocol.conditions[0].name)
    return setup.task.expected_duration(setup.world, route)


def schedule(protocol: Protocol, slot: int) -> tuple[ExpectedTrial, ...]:
    """Give a slot's trials with their expected times, the planned pause between two trials."""
    return scheduled(protocol, StudyPlan(protocol).trials(slot))


def scheduled(protocol: Protocol, trials: tuple[PlannedTrial, ...]) -> tuple[ExpectedTrial, ...]:
    """Give trials with their expected times; each visit starts from 0 s."""
    start, visit = 0.0, 0
    expected = []
    for trial in trials:
        if trial.visit != visit:
            start, visit = 0.0, trial.visit
        duration = expected_duration(protocol, trial.condition, trial.route)
        expected.append(ExpectedTrial(trial, start, duration))
        start += duration + protocol.session.pause
    return tuple(expected)


def session_duration(protocol: Protocol) -> float:
    """Say in s how long the longest visit of any slot is likely to take."""
    plan = StudyPlan(protocol)
    return max(
        expected.start_s + expected.duration_s
        for slot in range(protocol.participants.count)
        for expected in scheduled(protocol, plan.trials(slot))
    )
