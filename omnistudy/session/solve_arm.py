"""Run a task of an arm without physics: the controller's rates are done exactly."""

from __future__ import annotations

from collections.abc import Callable, Iterator

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
    advance : told after each step which share of its motion that was. plan : when it is known
    already. Raises ImpossibleStart, TooManySteps, NotAnArmController, UnknownArm, BrokenArmPage, or
    ImpossibleTask when there is no plan.
    """
    at = start_of(task)
    if plan is None and is_led(task):
        plan = plan_task(task)
    steps: list[ArmStep] = []
    t = 0.0
    for index, motion in enumerate(task.motions):
        planned = as_published(task, motion, at) if plan is None else plan.motions[index]
        before = 0.0
        for moment, u in _moments(task, planned, at, t):
            steps.append(measured(moment))
            at = moment.configuration
            if advance is not None:
                advance(u - before)
            before = u
        t = steps[-1].t + planned.pace.dt
    return ArmRun(task.arm, tuple(steps))


def _moments(
    task: ArmTask, planned: PlannedMotion, at: Configuration, began: float
) -> Iterator[tuple[Moment, float]]:
    """Give each step, and the share of the motion's time that it came to."""
    lead, direction, driven = planned.lead, bearing(planned.lead), 0.0
    controller = controller_of(task, planned.motion)
    for step, done in enumerate(follow(controller, lead, at, planned.pace, task)):
        driven += done.drive
        moment = Moment(
            motion=planned.motion.name,
            step=step,
            t=began + step * planned.pace.dt,
            configuration=done.at,
            wanted=lead.hand(done.u),
            wanted_chair=lead.chair(done.u),
            driven=driven,
            bearing=direction,
            report=done.report,
        )
        yield moment, done.u
