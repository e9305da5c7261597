"""Why no plan was found for a task of an arm, and from where it could be done, in words."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.arm.check import PoseAnswer, PoseCheck
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.stand_off import in_words, nearest_stand_off
from omnistudy.arm.task import Motion

CHANGE_IT = (
    "move its goal or the chair's, or, in free space, let the chair carry the hand (carried: true)"
)
"""What to do with a task that is refused."""


class Stopped(NamedTuple):
    """The way that came furthest: what it was, the share of its time, what held it there."""

    motion: Motion
    start: Configuration
    says: str
    share: float
    hits: tuple[str, ...]


def why_stopped(stopped: Stopped) -> PoseAnswer:
    """Say where a way ended before its end, and from where its end could be reached."""
    held = f", held by {' and '.join(stopped.hits)}" if stopped.hits else ""
    way = f"of all ways tried, {stopped.says}" if stopped.says else "the published way"
    end = _end(stopped.motion, stopped.start, stopped.start)
    why = (
        f"{way} came furthest, and stops after {100 * stopped.share:.0f} % of its time{held}; "
        f"the hand's goal {end.answer}"
    )
    return end._replace(possible=False, answer=why)


def why_none(motion: Motion, at: Configuration) -> PoseAnswer:
    """Say that there is no posture to end in, and from where there is one."""
    if motion.chair_goal is None:
        end = _end(motion, at, at)
        return end._replace(possible=False, answer=f"the hand's goal: {end.answer}")
    there = Configuration(at.body, at.joints, motion.chair_goal.pose)
    end = _end(motion, at, there)
    why = (
        f"with the chair at its goal, {in_words(there.chair)}, no posture was found that brings "
        f"the hand to its own clear of all zones; it {end.answer}"
    )
    return end._replace(possible=False, answer=why)


def _end(motion: Motion, at: Configuration, near: Configuration) -> PoseAnswer:
    """Say whether the path's end can be reached, and how near to a place of the chair."""
    goal = motion.path(at.hand, at.base).pose(1.0)
    return PoseCheck(motion.name, 1.0, nearest_stand_off(near, goal)).in_numbers
