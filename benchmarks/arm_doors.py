"""The thesis's two doors, hinge left and right, from wherever the search puts the chair."""

from __future__ import annotations

import time
from math import degrees
from typing import NamedTuple

from omnistudy.arm.find import load_task
from omnistudy.arm.run import summaries
from omnistudy.arm.task import ArmTask
from omnistudy.registry import load_kind
from omnistudy.session.plan_arm import look_for_plan
from omnistudy.session.solve_arm import solve_task

DOORS = ("door_right", "door_right_following", "door_left", "door_left_following")


class Door(NamedTuple):
    """One door: whether it was planned, in s, over how many ways; mm and deg off, at worst."""

    name: str
    planned: bool
    seconds: float
    tries: int
    worst_mm: float
    worst_degrees: float
    answer: str


def doors() -> list[Door]:
    """Plan and run each with `dual_qp`; the chair's goal is left to the search."""
    return [_door(name) for name in DOORS]


def _door(name: str) -> Door:
    page = load_task(name)
    motions = tuple(
        motion.model_copy(update={"controller": None, "chair_goal": None})
        for motion in page.motions
    )
    controller = load_kind("controllers", "dual_qp")()
    task: ArmTask = page.model_copy(update={"controller": controller, "motions": motions})
    began = time.perf_counter()
    plan = look_for_plan(task)
    seconds = time.perf_counter() - began
    if plan.refused is not None:
        return Door(name, False, seconds, plan.tries, 0.0, 0.0, plan.refused.answer)
    done = summaries(solve_task(task, plan=plan))
    return Door(
        name,
        True,
        seconds,
        plan.tries,
        1000 * max(summary.worst_error for summary in done),
        degrees(max(summary.worst_turn for summary in done)),
        plan.motions[-1].answer.answer,
    )
