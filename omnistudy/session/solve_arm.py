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


def solve_task(task: ArmTask, advance: Callable[..., None] | None = None) -> ArmRun:
    """Run all motions, one after the other; gives every step.

    Motions of a controller that leads the chair are planned first, the others go as published.
    advance : told after each motion. Raises ImpossibleStart, UnknownArm, BrokenArmPage, or
    ImpossibleTask when there is no plan.
    """
    at = start_of(task)
    planned = plan_task(task).motions if is_led(task) else None
    steps: list[ArmStep] = []
    t = 0.0
    for index, motion in enumerate(task.motions):
        plan = as_published(task, motion, at) if planned is None else planned[index]
        done, at, t = _motion(task, plan, at, t)
        steps.extend(done)
        if advance is not None:
            advance()
    return ArmRun(task.arm, tuple(steps))


def _motion(
    task: ArmTask, plan: PlannedMotion, at: Configuration, began: float
) -> tuple[list[ArmStep], Configuration, float]:
    lead, dt = plan.lead, plan.pace.dt
    direction, driven, t = bearing(lead), 0.0, began
    steps: list[ArmStep] = []
    controller = controller_of(task, plan.motion)
    for step, done in enumerate(follow(controller, lead, at, plan.pace, task)):
        at = done.at
        driven += done.drive
        t = began + step * dt
        moment = Moment(
            motion=plan.motion.name,
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
