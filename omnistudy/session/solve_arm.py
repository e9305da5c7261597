"""Run a task of an arm without physics: the controller's rates are done exactly."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import atan2, hypot, nan
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.check import check_task, start_of
from omnistudy.arm.configuration import ArmState, Configuration
from omnistudy.arm.duration import durations
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.paths import Path
from omnistudy.arm.profile import Chair
from omnistudy.arm.run import ArmRun, ArmStep, Moment, measured
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.controllers import Controller
from omnistudy.devices import DeviceState
from omnistudy.errors.arm import ImpossibleTask, NotAnArmController, TooManySteps
from omnistudy.geometry import PlanarPose
from omnistudy.geometry.rigid_motion import pose_error, sine_error
from omnistudy.registry import kinds, load_kind

Floats = NDArray[np.float64]

MOST_STEPS = 100_000
"""Of one motion: 83 minutes at the usual step."""

LEADS_NOWHERE = 1e-6
"""m over the floor below which a path has no bearing."""


def refuse_impossible(task: ArmTask, advance: Callable[..., None] | None = None) -> None:
    """Check a task before anything moves; raises ImpossibleTask with the reason.

    advance : told after each pose that is looked at.
    """
    for pose in check_task(task, advance).poses:
        if not pose.possible:
            raise ImpossibleTask(pose.motion, pose.answer)


def arm_controllers() -> tuple[str, ...]:
    """Name the kinds of controllers that lead arms: those that report each step."""
    return tuple(
        kind
        for kind in kinds("controllers")
        if _leads_arms(load_kind("controllers", kind).model_construct())
    )


def solve_task(task: ArmTask, advance: Callable[..., None] | None = None) -> ArmRun:
    """Run all motions, one after the other; gives every step.

    advance : told after each step which share of its motion that was. Raises ImpossibleStart,
    TooManySteps, NotAnArmController, UnknownArm or BrokenArmPage.
    """
    at = start_of(task)
    steps: list[ArmStep] = []
    t = 0.0
    for motion in task.motions:
        lead = _lead(task, motion, at)
        for moment in _moments(lead, at, t):
            steps.append(measured(moment))
            at = moment.configuration
            if advance is not None:
                advance(1.0 / (lead.last + 1))
        t += (lead.last + 1) * lead.dt
    return ArmRun(task.arm, tuple(steps))


class _Lead(NamedTuple):
    """What leads hand and chair through one motion; `last` is its last step, the first is 0."""

    motion: Motion
    controller: Controller
    difference: Callable[[Floats, Floats], Floats]
    path: Path
    route: ChairRoute | None
    bearing: float
    last: int
    dt: float


def _lead(task: ArmTask, motion: Motion, at: Configuration) -> _Lead:
    controller: Controller = motion.controller or task.controller
    if not _leads_arms(controller):
        raise NotAnArmController(controller.kind, arm_controllers())
    path = motion.path(at.hand, at.base)
    count, dt = _steps(task, motion, path, at)
    chair, goal = at.body.profile.chair, motion.chair_goal
    return _Lead(
        motion=motion,
        controller=controller,
        difference=pose_error if task.error == "logarithm" else sine_error,
        path=path,
        route=None if goal is None else ChairRoute.of_chair(chair, at.chair, goal.pose),
        bearing=_bearing(path),
        last=count,
        dt=dt,
    )


def _leads_arms(controller: Controller) -> bool:
    return hasattr(controller.initial_state(), "report")


def _moments(lead: _Lead, at: Configuration, began: float) -> Iterator[Moment]:
    """Lead the hand along its path: at each step all that is missing is asked for at once."""
    motion, dt, chair = lead.motion, lead.dt, at.body.profile.chair
    goal = motion.chair_goal.pose if motion.chair_goal else None
    state, driven = lead.controller.initial_state(), 0.0
    for step in range(lead.last + 1):
        u = step / lead.last if lead.last else 1.0
        wanted = lead.path.pose(motion.timing.share(u))
        guidance = Guidance(lead.difference(at.hand, wanted) / dt, lead.bearing, goal)
        device = DeviceState(guidance.numbers, (0.0,) * len(guidance.numbers))
        control = lead.controller.control(device, ArmState(at), None, state, dt)
        state, at = control.state, at.moved(control.command, dt)
        driven += float(control.command[at.body.count]) * dt
        yield Moment(
            motion=motion.name,
            step=step,
            t=began + step * dt,
            configuration=at,
            wanted=wanted,
            wanted_chair=_on_route(lead, chair, u),
            driven=driven,
            bearing=lead.bearing,
            report=state.report,
        )


def _on_route(lead: _Lead, chair: Chair, u: float) -> PlanarPose | None:
    if lead.route is None:
        return None
    return lead.route.chair_pose(chair, lead.route.shares(u, chair, lead.motion.timing))


def _steps(task: ArmTask, motion: Motion, path: Path, at: Configuration) -> tuple[int, float]:
    """Give how many steps follow the first, and how long each is in s."""
    needed = durations(motion, path, at)
    duration = needed.hand if motion.pace == "hand" else needed.longest
    if duration == 0.0:
        return 0, task.step
    if duration / task.step > MOST_STEPS:
        raise TooManySteps(motion.name, duration, task.step, MOST_STEPS)
    count = max(1, round(duration / task.step))
    return count, duration / count


def _bearing(path: Path) -> float:
    x, y = path.leads.tolist()
    return atan2(y, x) if hypot(x, y) > LEADS_NOWHERE else nan
