"""Run a task of an arm without physics: the controller's rates are done exactly."""

from __future__ import annotations

from collections.abc import Callable

from omnistudy.arm.check import check_task, start_of
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.run import ArmRun, ArmStep, Moment, measured
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import ImpossibleTask
from omnistudy.session.follow_arm import bearing, follow
from omnistudy.session.plan_arm import (
    Plan,
    PlannedMotion,
    as_published,
    controller_of,
    is_led,
    plan_task,
)


def refuse_impossible(task: ArmTask, advance: Callable[..., None] | None = None) -> None:
    """Check a task before anything moves; raises ImpossibleTask with the reason.

    advance : told after each pose that is looked at.
    """
    for pose in check_task(task, advance).poses:
        if not pose.possible:
            raise ImpossibleTask(pose.motion, pose.answer)


def solve_task(
    task: ArmTask, advance: Callable[..., None] | None = None, plan: Plan | None = None
) -> ArmRun:
    """Run all motions, one after the other; gives every step.

    Motions of a controller that leads the chair go as planned, the others as published.
    advance : told after each motion. plan : when it is known already. Raises ImpossibleStart,
    UnknownArm, BrokenArmPage, or ImpossibleTask when there is no plan.
    """
    at = start_of(task)
    if plan is None and is_led(task):
        plan = plan_task(task)
    steps: list[ArmStep] = []
    t = 0.0
    for index, motion in enumerate(task.motions):
        planned = as_published(task, motion, at) if plan is None else plan.motions[index]
        done, at, t = _motion(task, planned, at, t)
        steps.extend(done)
        if advance is not None:
            advance()
    return ArmRun(task.arm, tuple(steps))


def _motion(
    task: ArmTask, planned: PlannedMotion, at: Configuration, began: float
) -> tuple[list[ArmStep], Configuration, float]:
    lead, dt = planned.lead, planned.pace.dt
    direction, driven, t = bearing(lead), 0.0, began
    steps: list[ArmStep] = []
    controller = controller_of(task, planned.motion)
    for step, done in enumerate(follow(controller, lead, at, planned.pace, task)):
        at = done.at
        driven += done.drive
        t = began + step * dt
        moment = Moment(
            motion=planned.motion.name,
            step=step,
            t=t,
            configuration=at,
            wanted=lead.hand(done.u),
            wanted_chair=lead.chair(done.u),
            driven=driven,
            bearing=direction,
            report=done.report,
        )
        steps.append(measured(moment))
    return steps, at, t + dt
