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
from omnistudy.arm.check import PoseAnswer, start_of
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.duration import durations
from omnistudy.arm.lead import ChairLead, Lead, WorldLead
from omnistudy.arm.stand_off import in_words
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.arm.ways import ways
from omnistudy.controllers import Controller
from omnistudy.controllers.led import LedController
from omnistudy.errors.arm import ImpossibleTask, NotAnArmController, TooManySteps
from omnistudy.geometry.rigid_motion import pose_error
from omnistudy.registry import kinds, load_kind
from omnistudy.session.follow_arm import ARRIVED, Followed, Pace, follow
from omnistudy.session.refuse_arm import CHANGE_IT, Stopped, why_none, why_stopped

COARSE = 4
"""Steps of a task that the first look takes at once."""

MOST_TRIES = 600
"""Ways looked at in all, before a task is given up."""

MOST_STEPS = 100_000
"""Of one motion: 83 minutes at the usual step."""

ARRIVES = (1e-4, radians(0.02))
"""m, rad within which the hand is at the end of its way."""

KEEPS = (1e-3, radians(0.2))
"""m, rad within which it is on its way; in a coarse look `COARSE` squared times as much."""


class PlannedMotion(NamedTuple):
    """One motion, where it was planned from, how it is done, and where it ends, once known."""

    motion: Motion
    start: Configuration
    lead: Lead
    pace: Pace
    says: str = ""
    end: Configuration | None = None

    @property
    def answer(self) -> PoseAnswer:
        """Say how hand and chair go, and where they end."""
        at = self.end or self.start
        says = f"{self.says or 'as published'}, to {in_words(at.chair)}"
        joints, zones = tuple(at.joints.tolist()), at.intrusions.names
        return PoseAnswer(self.motion.name, 1.0, True, at.chair, joints, 0.0, 0.0, zones, says)


class Plan(NamedTuple):
    """How a task is done; or, without motions, which one is refused and why.

    tries : ways that were looked at.
    """

    motions: tuple[PlannedMotion, ...]
    tries: int
    refused: PoseAnswer | None = None


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


def arm_controllers() -> tuple[str, ...]:
    """Name the kinds of controllers that lead arms: those that report each step."""
    return tuple(
        kind
        for kind in kinds("controllers")
        if leads_arms(load_kind("controllers", kind).model_construct())
    )


def leads_arms(controller: Controller) -> bool:
    """Whether a controller is one of an arm."""
    return hasattr(controller.initial_state(), "report")


def is_led(task: ArmTask) -> bool:
    """Whether any of its motions has a controller that leads the chair too."""
    return any(isinstance(controller_of(task, m), LedController) for m in task.motions)


def as_published(task: ArmTask, motion: Motion, at: Configuration) -> PlannedMotion:
    """Give the only way of a controller that does not lead the chair: the hand's path.

    Raises NotAnArmController or TooManySteps.
    """
    if not leads_arms(controller_of(task, motion)):
        raise NotAnArmController(controller_of(task, motion).kind, arm_controllers())
    path = motion.path(at.hand, at.base)
    needed = durations(motion, path, at)
    duration = needed.hand if motion.pace == "hand" else needed.longest
    way = None
    if motion.chair_goal is not None:
        route = ChairRoute.of_chair(at.body.profile.chair, at.chair, motion.chair_goal.pose)
        way = ChairLead(at.body, route, motion.timing)
    lead = WorldLead(path, motion.timing, way)
    return PlannedMotion(motion, at, lead, _pace(motion, duration, task.step))


def plan_task(task: ArmTask, advance: Callable[..., None] | None = None) -> Plan:
    """Find a way for every motion; raises ImpossibleTask with the reason, or ImpossibleStart.

    advance : told after each way that was looked at.
    """
    plan = look_for_plan(task, advance)
    if plan.refused is not None:
        raise ImpossibleTask(plan.refused.motion, plan.refused.answer, CHANGE_IT)
    return plan


def look_for_plan(task: ArmTask, advance: Callable[..., None] | None = None) -> Plan:
    """Find a way for every motion, or why there is none; raises ImpossibleStart."""
    search = _Search(task, advance)
    for motions in search.plans(start_of(task), ()):
        held = search.held(motions)
        if held:
            return Plan(held, search.tries)
    return Plan((), search.tries, search.refused())


class _Search:
    """Depth first over the ways of each motion; remembers what came furthest."""

    def __init__(self, task: ArmTask, advance: Callable[..., None] | None) -> None:
        self.task = task
        self.tries = 0
        self._advance = advance
        self._furthest: tuple[int, float] = (-1, 0.0)
        self._stopped: Stopped | None = None
        self._nowhere: tuple[Motion, Configuration] | None = None

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
            outcome = self._tried(planned, at, COARSE)
            self.tries += 1
            if self._advance is not None:
                self._advance()
            if outcome.arrived:
                yield from self.plans(outcome.at, (*before, planned))
            else:
                self._remember(len(before), planned, outcome)
        if none and (len(before), 0.0) > self._furthest:
            self._furthest, self._nowhere = (len(before), 0.0), (motion, at)

    def held(self, motions: tuple[PlannedMotion, ...]) -> tuple[PlannedMotion, ...]:
        """Go through it step by step; give it with where each motion ends, or nothing."""
        at, done = start_of(self.task), []
        for index, planned in enumerate(motions):
            outcome = self._tried(planned, at, 1)
            if not outcome.arrived:
                self._remember(index, planned, outcome)
                return ()
            at = outcome.at
            done.append(planned._replace(end=at))
        return tuple(done)

    def refused(self) -> PoseAnswer:
        """Say of the motion that came furthest what stopped it."""
        if self._stopped is not None and (self._nowhere is None or self._furthest[1] > 0.0):
            return why_stopped(self._stopped)
        return why_none(*(self._nowhere or (self.task.motions[0], start_of(self.task))))

    def _candidates(self, motion: Motion, at: Configuration) -> Iterator[PlannedMotion]:
        if not isinstance(controller_of(self.task, motion), LedController):
            yield as_published(self.task, motion, at)
            return
        for way in ways(motion, at):
            pace = _pace(motion, way.duration, self.task.step)
            yield PlannedMotion(motion, at, way.lead, pace, way.says)

    def _tried(self, planned: PlannedMotion, at: Configuration, coarse: int) -> Outcome:
        pace = planned.pace
        if coarse > 1 and pace.steps > coarse:
            steps = -(-pace.steps // coarse)
            pace = Pace(steps, pace.dt * pace.steps / steps)
        controller = controller_of(self.task, planned.motion)
        led = isinstance(controller, LedController)
        turns = not isinstance(controller, LedController) or controller.turns_hand
        for done in follow(controller, planned.lead, at, pace, self.task):
            off = _off(done, planned.lead, turns)
            if led and _beyond(off, KEEPS, coarse**2):
                break
        arrived = done.u >= ARRIVED and not _beyond(off, ARRIVES)
        return Outcome(done.at, done.u, arrived, done.report.hits)

    def _remember(self, index: int, planned: PlannedMotion, outcome: Outcome) -> None:
        if (index, outcome.share) > self._furthest:
            self._furthest = (index, outcome.share)
            self._stopped = Stopped(
                planned.motion, planned.start, planned.says, outcome.share, outcome.hits
            )


def _off(done: Followed, lead: Lead, turns: bool) -> tuple[float, float]:
    """Give m and rad from the hand to where it is led; no rad where its turn does not matter."""
    error = pose_error(done.at.hand, lead.hand(done.u))
    return float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:])) if turns else 0.0


def _beyond(off: tuple[float, float], bounds: tuple[float, float], times: float = 1.0) -> bool:
    return off[0] > times * bounds[0] or off[1] > times * bounds[1]


def _pace(motion: Motion, duration: float, step: float) -> Pace:
    if duration == 0.0:
        return Pace(0, step)
    if duration / step > MOST_STEPS:
        raise TooManySteps(motion.name, duration, step, MOST_STEPS)
    steps = max(1, round(duration / step))
    return Pace(steps, duration / steps)
