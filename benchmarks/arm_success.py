"""How often each controller brings hand and chair of an arm to random goals, zones and all."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from math import hypot, radians
from typing import Any, NamedTuple

import numpy as np
from arm_tasks import random_task
from scipy.stats import binomtest

from omnistudy.arm.chair import axle
from omnistudy.arm.check import start_of
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.task import ArmTask
from omnistudy.geometry import wrapped
from omnistudy.geometry.rigid_motion import pose_error
from omnistudy.registry import load_kind
from omnistudy.session.follow_arm import follow
from omnistudy.session.plan_arm import PlannedMotion, as_published, is_led, look_for_plan

HAND = (1e-3, radians(0.2))
"""m, rad within which the hand has arrived."""

CHAIR = (0.02, radians(1.0))
"""m, rad within which the chair has."""

TOUCH = 1e-6
"""m into a zone that count as entering it."""

WORKERS = 2

CONTROLLERS: dict[str, tuple[str, dict[str, Any]]] = {
    **{kind: (kind, {}) for kind in ("sri_wln", "pi_wln", "sri_ene", "pi_ene", "dual_qp")},
    "sri_wln, printed weights": ("sri_wln", {"chair_weights": {"kind": "printed"}}),
}
"""Name in the table -> kind and what differs from its defaults."""


class Outcome(NamedTuple):
    """How one task ended."""

    hand: bool
    chair: bool
    clear: bool
    refused: bool = False

    @property
    def solved(self) -> bool:
        """Whether hand and chair both arrived and no zone was entered on the way."""
        return self.hand and self.chair and self.clear


class Share(NamedTuple):
    """So many of so many, in percent, with the 95 % interval of Clopper and Pearson."""

    count: int
    of: int

    def __str__(self) -> str:
        found = binomtest(self.count, self.of).proportion_ci(method="exact")
        low, high = 100 * found.low, 100 * found.high
        return f"{100 * self.count / self.of:.1f} ({low:.1f} to {high:.1f})"


def outcomes(
    name: str, degrees: int, seed: str, tasks: int, advance: Callable[[], None]
) -> list[Outcome]:
    """Run all tasks of a bearing class with one controller, on `WORKERS` processes."""
    run = partial(outcome, name, degrees, seed)
    found = []
    with ProcessPoolExecutor(WORKERS) as pool:
        for one in pool.map(run, range(tasks), chunksize=4):
            found.append(one)
            advance()
    return found


def outcome(name: str, degrees: int, seed: str, number: int) -> Outcome:
    """Run one task from its start to its end."""
    kind, parameters = CONTROLLERS[name]
    task = random_task(seed, number, degrees, load_kind("controllers", kind)(**parameters))
    start = start_of(task)
    if is_led(task):
        plan = look_for_plan(task)
        if not plan.motions:
            return Outcome(False, False, True, refused=True)
        return _judged(task, plan.motions[0], start)
    return _judged(task, as_published(task, task.motions[0], start), start)


def _judged(task: ArmTask, planned: PlannedMotion, start: Configuration) -> Outcome:
    clear, at = True, start
    for done in follow(task.controller, planned.lead, start, planned.pace, task):
        at = done.at
        clear = clear and _is_clear(at)
    motion = planned.motion
    error = pose_error(at.hand, motion.path(start.hand, start.base).pose(1.0))
    hand = _within(float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:])), HAND)
    assert motion.chair_goal is not None
    profile = at.body.profile.chair
    here, there = axle(profile, at.chair), axle(profile, motion.chair_goal.pose)
    off = hypot(here.x - there.x, here.y - there.y)
    return Outcome(hand, _within(off, abs(wrapped(here.theta - there.theta)), CHAIR), clear)


def _is_clear(at: Configuration) -> bool:
    return bool((at.body.clearances.near(at.frames, 1.0).rooms > -TOUCH).all())


def _within(way: float, turn: float, bounds: tuple[float, float]) -> bool:
    return way <= bounds[0] and turn <= bounds[1]


def share(found: Iterable[bool]) -> Share:
    """Count."""
    listed = list(found)
    return Share(sum(listed), len(listed))
