"""What can be said of a task before anything moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import degrees
from typing import NamedTuple

import numpy as np

from omnistudy.arm.configuration import ArmBody, Configuration
from omnistudy.arm.find import load_arm
from omnistudy.arm.stand_off import StandOff, in_words, nearest_stand_off
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.errors.arm import ImpossibleStart
from omnistudy.geometry import PlanarPose

ARC_LOOKS = (0.25, 0.5, 0.75, 1.0)
"""Shares of an arc that are checked; of a line, its end."""


class PoseCheck(NamedTuple):
    """One pose on the way: from here, from elsewhere, or not at all.

    share : of the motion's path. nearest : the nearest chair pose found, or where the hand comes
    nearest.
    """

    motion: str
    share: float
    nearest: StandOff

    @property
    def possible(self) -> bool:
        """Whether the pose is reached from anywhere."""
        return self.nearest.reached

    @property
    def in_numbers(self) -> PoseAnswer:
        """Give it for other programs."""
        at = self.nearest.configuration
        return PoseAnswer(
            self.motion,
            self.share,
            self.possible,
            at.chair,
            tuple(at.joints.tolist()),
            *self.nearest.short,
            at.intrusions.names,
            self.answer,
        )

    @property
    def answer(self) -> str:
        """Say it in a sentence."""
        zones = self.nearest.configuration.intrusions.names
        touching = f", with the arm in zone {' and '.join(zones)}" if zones else ""
        place = in_words(self.nearest.configuration.chair)
        if not self.possible:
            short, turn = self.nearest.short
            return (
                f"no chair pose was found from which the arm reaches it: from {place} the hand "
                f"is still {1000 * short:.0f} mm and {degrees(turn):.0f} deg short"
            )
        if self.nearest.distance == 0.0 and self.nearest.turn == 0.0:
            return f"can be reached from where the chair stands{touching}"
        return f"can be reached with the chair at {place}{touching}"


class PoseAnswer(NamedTuple):
    """A pose's answer for other programs.

    chair : the stand-off, x, y in m and heading in rad. short, short_turn : what is missing, m
    and rad. zones : what the arm is in.
    """

    motion: str
    share: float
    possible: bool
    chair: PlanarPose
    joints: tuple[float, ...]
    short: float
    short_turn: float
    zones: tuple[str, ...]
    answer: str


class TaskCheck(NamedTuple):
    """All poses that were checked."""

    title: str
    poses: tuple[PoseCheck, ...]

    @property
    def possible(self) -> bool:
        """Whether every pose is reached from somewhere."""
        return all(pose.possible for pose in self.poses)


def start_of(task: ArmTask) -> Configuration:
    """Give where a task starts; raises ImpossibleStart, UnknownArm or BrokenArmPage."""
    profile = load_arm(task.arm)
    body = ArmBody(profile)
    given = task.start.joints
    joints = np.array(getattr(profile, given) if isinstance(given, str) else given)
    if len(joints) != body.count:
        raise ImpossibleStart(f"{len(joints)} angles are given, '{task.arm}' has {body.count}")
    for index in np.flatnonzero((joints < body.lower) | (joints > body.upper)):
        raise ImpossibleStart(
            f"joint {index + 1} is at {joints[index]:.4f} rad, and its limits are "
            f"{body.lower[index]:.4f} and {body.upper[index]:.4f} rad"
        )
    return Configuration(body, joints, task.start.chair.pose)


def check_task(task: ArmTask, advance: Callable[..., None] | None = None) -> TaskCheck:
    """Check that every motion's poses can be reached from somewhere.

    Each motion is taken to begin where the one before ended, in the stand-off found for it. The
    poses of an arc are checked one by one; that one stand-off serves them all is not said.
    advance : told after each pose.
    """
    at = start_of(task)
    checks: list[PoseCheck] = []
    for motion in task.motions:
        for check in _checked(motion, at):
            checks.append(check)
            if advance is not None:
                advance()
        at = checks[-1].nearest.configuration
    return TaskCheck(task.title, tuple(checks))


def looks(task: ArmTask) -> int:
    """Give how many poses `check_task` looks at."""
    return sum(len(_shares(motion)) for motion in task.motions)


def _shares(motion: Motion) -> tuple[float, ...]:
    return (1.0,) if motion.hinge is None else ARC_LOOKS


def _checked(motion: Motion, at: Configuration) -> Iterator[PoseCheck]:
    path = motion.path(at.hand, at.base)
    for share in _shares(motion):
        goal = path.pose(share)
        nearest = nearest_stand_off(at, goal)
        yield PoseCheck(motion.name, share, nearest)
