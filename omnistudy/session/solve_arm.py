"""Run a task of an arm without physics: the controller's rates are done exactly."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, hypot, nan

from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.check import check_task, start_of
from omnistudy.arm.configuration import ArmState, Configuration
from omnistudy.arm.duration import durations
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.paths import Path
from omnistudy.arm.run import ArmRun, ArmStep, Moment, measured
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.controllers import Controller
from omnistudy.devices import DeviceState
from omnistudy.errors.arm import ImpossibleTask
from omnistudy.geometry.rigid_motion import pose_error, sine_error

LEADS_NOWHERE = 1e-6
"""m over the floor below which a path has no bearing."""


def refuse_impossible(task: ArmTask, advance: Callable[..., None] | None = None) -> None:
    """Check a task before anything moves; raises ImpossibleTask with the reason.

    advance : told after each pose that is looked at.
    """
    for pose in check_task(task, advance).poses:
        if not pose.possible:
            raise ImpossibleTask(pose.motion, pose.answer)


def solve_task(task: ArmTask, advance: Callable[..., None] | None = None) -> ArmRun:
    """Run all motions, one after the other; gives every step.

    advance : told after each motion. Raises ImpossibleStart, UnknownArm or BrokenArmPage.
    """
    at = start_of(task)
    steps: list[ArmStep] = []
    t = 0.0
    for motion in task.motions:
        done, at, t = _motion(task, motion, at, t)
        steps.extend(done)
        if advance is not None:
            advance()
    return ArmRun(task.arm, tuple(steps))


def _motion(
    task: ArmTask, motion: Motion, at: Configuration, began: float
) -> tuple[list[ArmStep], Configuration, float]:
    """Lead the hand along one path: at each step all that is missing is asked for at once."""
    controller: Controller = motion.controller or task.controller
    path = motion.path(at.hand, at.base)
    chair = at.body.profile.chair
    count, dt = _steps(task, motion, path, at)
    bearing, goal = _bearing(path), motion.chair_goal.pose if motion.chair_goal else None
    difference = pose_error if task.error == "logarithm" else sine_error
    route = None if goal is None else ChairRoute.of_chair(chair, at.chair, goal)
    state, driven = controller.initial_state(), 0.0
    steps = []
    for step in range(count + 1):
        u = step / count if count else 1.0
        wanted = path.pose(motion.timing.share(u))
        aside = route and route.chair_pose(chair, route.shares(u, chair, motion.timing))
        guidance = Guidance(difference(at.hand, wanted) / dt, bearing, goal)
        device = DeviceState(guidance.numbers, (0.0,) * len(guidance.numbers))
        control = controller.control(device, ArmState(at), None, state, dt)
        state, at = control.state, at.moved(control.command, dt)
        driven += float(control.command[at.body.count]) * dt
        moment = Moment(
            motion.name, step, began + step * dt, at, wanted, aside, driven, bearing, state.report
        )
        steps.append(measured(moment))
    return steps, at, began + (count + 1) * dt


def _steps(task: ArmTask, motion: Motion, path: Path, at: Configuration) -> tuple[int, float]:
    """Give how many steps follow the first, and how long each is in s."""
    needed = durations(motion, path, at)
    duration = needed.hand if motion.pace == "hand" else needed.longest
    if duration == 0.0:
        return 0, task.step
    count = max(1, round(duration / task.step))
    return count, duration / count


def _bearing(path: Path) -> float:
    x, y = path.leads.tolist()
    return atan2(y, x) if hypot(x, y) > LEADS_NOWHERE else nan
