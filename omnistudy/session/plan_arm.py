"""Say before anything moves whether, and from where, a task of an arm can be done.

Every way that is thought of is gone through without physics, coarsely; one that comes to its end is
gone through again step by step, and is then what the task does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import islice
from math import degrees
from typing import NamedTuple

import numpy as np

from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.check import start_of
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.duration import durations
from omnistudy.arm.lead import ChairLead, Lead, WorldLead
from omnistudy.arm.stand_off import in_words
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.arm.ways import Way, ways
from omnistudy.controllers import Controller
from omnistudy.controllers.led import LedController
from omnistudy.errors.arm import ImpossibleTask
from omnistudy.geometry.rigid_motion import pose_error
from omnistudy.session.follow_arm import Pace, follow

COARSE = 4
"""Steps of a task that the first look takes at once."""

MOST_TRIES = 600
"""Ways looked at in all, before a task is given up."""

HAND_ARRIVES = (1e-3, np.radians(0.2))
"""m, rad."""

OFF_THE_WAY = (0.01, np.radians(2.0))
"""m, rad that the hand may be off its way at any time."""


class PlannedMotion(NamedTuple):
    """One motion, and how it is done."""

    motion: Motion
    lead: Lead
    pace: Pace
    says: str = ""


class Plan(NamedTuple):
    """How a task is done; `tries` ways were looked at."""

    motions: tuple[PlannedMotion, ...]
    tries: int


class Outcome(NamedTuple):
    """How one way went: the share of its time it came to, and what held it there."""

    at: Configuration
    share: float
    arrived: bool
    hits: tuple[str, ...]


def controller_of(task: ArmTask, motion: Motion) -> Controller:
    """Give the controller of a motion."""
    controller: Controller = motion.controller or task.controller
    return controller


def is_led(task: ArmTask) -> bool:
    """Whether any of its motions has a controller that leads the chair too."""
    return any(isinstance(controller_of(task, m), LedController) for m in task.motions)


def as_published(task: ArmTask, motion: Motion, at: Configuration) -> PlannedMotion:
    """Give the only way of a controller that does not lead the chair: the hand's path."""
    path = motion.path(at.hand, at.base)
    needed = durations(motion, path, at)
    duration = needed.hand if motion.pace == "hand" else needed.longest
    way = None
    if motion.chair_goal is not None:
        route = ChairRoute.of_chair(at.body.profile.chair, at.chair, motion.chair_goal.pose)
        way = ChairLead(at.body, route, motion.timing)
    return PlannedMotion(motion, WorldLead(path, motion.timing, way), _pace(duration, task.step))


def plan_task(task: ArmTask, advance: Callable[..., None] | None = None) -> Plan:
    """Find a way for every motion; raises ImpossibleTask with the reason.

    advance : told after each way that was looked at, with how many motions it did at most.
    """
    search = _Search(task, advance)
    for plan in search.plans(start_of(task), ()):
        if search.holds(plan):
            return Plan(plan, search.tries)
    raise ImpossibleTask(*search.refusal)


class _Search:
    """Depth first over the ways of each motion."""

    def __init__(self, task: ArmTask, advance: Callable[..., None] | None) -> None:
        self.task = task
        self.tries = 0
        self._advance = advance
        self._furthest: tuple[int, float] = (-1, 0.0)
        self.refusal = ("", "")

    def plans(
        self, at: Configuration, before: tuple[PlannedMotion, ...]
    ) -> Iterator[tuple[PlannedMotion, ...]]:
        """Give each plan that comes to its end when looked at coarsely."""
        if len(before) == len(self.task.motions):
            yield before
            return
        motion = self.task.motions[len(before)]
        none = True
        for planned in self._candidates(motion, at):
            none = False
            if self.tries >= MOST_TRIES:
                return
            self.tries += 1
            outcome = self._tried(planned, at, COARSE)
            if self._advance is not None:
                self._advance()
            if outcome.arrived:
                yield from self.plans(outcome.at, (*before, planned))
            else:
                self._remember(len(before), planned, outcome)
        if none:
            self._refuse_pose(len(before), motion, at)

    def holds(self, plan: tuple[PlannedMotion, ...]) -> bool:
        """Go through it step by step."""
        at = start_of(self.task)
        for index, planned in enumerate(plan):
            outcome = self._tried(planned, at, 1)
            if not outcome.arrived:
                self._remember(index, planned, outcome)
                return False
            at = outcome.at
        return True

    def _candidates(self, motion: Motion, at: Configuration) -> Iterator[PlannedMotion]:
        if not isinstance(controller_of(self.task, motion), LedController):
            yield as_published(self.task, motion, at)
            return
        for way in ways(motion, at):
            yield PlannedMotion(motion, way.lead, _pace(way.duration, self.task.step), way.says)

    def _tried(self, planned: PlannedMotion, at: Configuration, coarse: int) -> Outcome:
        pace = planned.pace
        if coarse > 1 and pace.count > coarse:
            count = -(-pace.count // coarse)
            pace = Pace(count, pace.dt * pace.count / count)
        controller = controller_of(self.task, planned.motion)
        off = False
        for done in follow(controller, planned.lead, at, pace, self.task):
            error = pose_error(done.at.hand, planned.lead.hand(done.u))
        way, turn = float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:]))
        arrived = done.u >= 1.0 and way <= HAND_ARRIVES[0] and turn <= HAND_ARRIVES[1] and not off
        return Outcome(done.at, done.u, arrived, done.report.hits)

    def _remember(self, index: int, planned: PlannedMotion, outcome: Outcome) -> None:
        """Keep the reason of what came furthest."""
        if (index, outcome.share) <= self._furthest:
            return
        self._furthest = (index, outcome.share)
        held = f", held by {' and '.join(outcome.hits)}" if outcome.hits else ""
        self.refusal = (
            planned.motion.name,
            f"of the ways that were tried the best {planned.says} comes to a stand after "
            f"{100 * outcome.share:.0f} % of its time{held}, with the chair at "
            f"{in_words(outcome.at.chair)}",
        )

    def _refuse_pose(self, index: int, motion: Motion, at: Configuration) -> None:
        if (index, 0.0) <= self._furthest:
            return
        self._furthest = (index, 0.0)
        self.refusal = (motion.name, "nothing")


def _pace(duration: float, step: float) -> Pace:
    if duration == 0.0:
        return Pace(0, step)
    count = max(1, round(duration / step))
    return Pace(count, duration / count)
