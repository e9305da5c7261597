"""Say before anything moves whether, and from where, a task of an arm can be done.

Every way that is thought of is gone through without physics, coarsely; one that comes to its end is
gone through again step by step, and is then what the task does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import radians
from typing import NamedTuple

import numpy as np

from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.check import PoseCheck, start_of
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.duration import durations
from omnistudy.arm.lead import ChairLead, Lead, WorldLead
from omnistudy.arm.stand_off import in_words, nearest_stand_off
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.arm.ways import ways
from omnistudy.controllers import Controller
from omnistudy.controllers.led import LedController
from omnistudy.errors.arm import ImpossibleTask
from omnistudy.geometry.rigid_motion import pose_error
from omnistudy.session.follow_arm import ARRIVED, Followed, Pace, follow

COARSE = 4
"""Steps of a task that the first look takes at once."""

MOST_TRIES = 600
"""Ways looked at in all, before a task is given up."""

ARRIVES = (1e-4, radians(0.02))
"""m, rad within which the hand is at the end of its way."""

KEEPS = (1e-3, radians(0.2))
"""m, rad within which it is on its way; in a coarse look `COARSE` squared times as much."""

CHANGE_IT = "give it another goal or another chair_goal, or let the hand be carried"
"""What to do with a task that is refused."""


class PlannedMotion(NamedTuple):
    """One motion, and how it is done."""

    motion: Motion
    start: Configuration
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
    return PlannedMotion(
        motion, at, WorldLead(path, motion.timing, way), _pace(duration, task.step)
    )


def plan_task(task: ArmTask, advance: Callable[..., None] | None = None) -> Plan:
    """Find a way for every motion; raises ImpossibleTask with the reason.

    advance : told after each way that was looked at, with how many motions it did at most.
    """
    search = _Search(task, advance)
    for plan in search.plans(start_of(task), ()):
        if search.holds(plan):
            return Plan(plan, search.tries)
    raise ImpossibleTask(*search.refusal, CHANGE_IT)


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
            yield PlannedMotion(motion, at, way.lead, _pace(way.duration, self.task.step), way.says)

    def _tried(self, planned: PlannedMotion, at: Configuration, coarse: int) -> Outcome:
        pace = planned.pace
        if coarse > 1 and pace.steps > coarse:
            steps = -(-pace.steps // coarse)
            pace = Pace(steps, pace.dt * pace.steps / steps)
        controller = controller_of(self.task, planned.motion)
        off = (0.0, 0.0)
        led = isinstance(controller, LedController)
        for done in follow(controller, planned.lead, at, pace, self.task):
            off = _off(done, planned.lead)
            if led and _beyond(off, KEEPS, coarse**2):
                break
        arrived = done.u >= ARRIVED and not _beyond(off, ARRIVES)
        return Outcome(done.at, done.u, arrived, done.report.hits)

    def _remember(self, index: int, planned: PlannedMotion, outcome: Outcome) -> None:
        """Keep the reason of what came furthest."""
        if (index, outcome.share) <= self._furthest:
            return
        self._furthest = (index, outcome.share)
        held = f", held by {' and '.join(outcome.hits)}" if outcome.hits else ""
        path = planned.motion.path(planned.start.hand, planned.start.base)
        end = PoseCheck(planned.motion.name, 1.0, nearest_stand_off(planned.start, path.pose(1.0)))
        self.refusal = (
            planned.motion.name,
            f"the way that came furthest, {planned.says}, stops after "
            f"{100 * outcome.share:.0f} % of it{held}; its end {end.answer}",
        )

    def _refuse_pose(self, index: int, motion: Motion, at: Configuration) -> None:
        """Say that there is not even a posture to end in."""
        if (index, 0.0) <= self._furthest:
            return
        self._furthest = (index, 0.0)
        path = motion.path(at.hand, at.base)
        if motion.chair_goal is None:
            nearest = nearest_stand_off(at, path.pose(1.0))
            self.refusal = (motion.name, f"its end: {PoseCheck(motion.name, 1.0, nearest).answer}")
            return
        there = Configuration(at.body, at.joints, motion.chair_goal.pose)
        nearest = nearest_stand_off(there, path.pose(1.0))
        self.refusal = (
            motion.name,
            f"with the chair at its goal, {in_words(there.chair)}, no posture was found that brings "
            f"the hand to its own and enters no zone; it "
            f"{PoseCheck(motion.name, 1.0, nearest).answer}",
        )


def _off(done: Followed, lead: Lead) -> tuple[float, float]:
    """Give m and rad from the hand to where it is led."""
    error = pose_error(done.at.hand, lead.hand(done.u))
    return float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:]))


def _beyond(off: tuple[float, float], bounds: tuple[float, float], times: float = 1.0) -> bool:
    return off[0] > times * bounds[0] or off[1] > times * bounds[1]


def _pace(duration: float, step: float) -> Pace:
    if duration == 0.0:
        return Pace(0, step)
    count = max(1, round(duration / step))
    return Pace(count, duration / count)
