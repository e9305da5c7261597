"""How long a motion needs so that hand, chair and joints can all keep up."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.paths import Path
from omnistudy.arm.task import Motion
from omnistudy.geometry.rigid_motion import pose_error

LOOKS = 40
"""Places along a path at which the joints' rates are estimated."""

FLOOR = 1e-4
"""Keeps the walk's steps finite where the arm is singular; of J diag(top rates)^2 J'."""

LOST = 0.1
"""Share of a step of the walk that may be left undone for its rates to count."""


class Durations(NamedTuple):
    """Seconds that a motion needs for each of its parts.

    hand : at the hand's speeds. chair : for the chair's own goal, 0 without one. joints : for
    joints and chair to follow the hand.
    """

    hand: float
    chair: float
    joints: float

    @property
    def longest(self) -> float:
        """What all three are content with."""
        return max(self)


def durations(motion: Motion, path: Path, start: Configuration) -> Durations:
    """Estimate what a motion needs; exact for the hand, a walk along the path for the joints."""
    hand = motion.hand_duration(path)
    chair = 0.0
    if motion.chair_goal is not None:
        profile = start.body.profile.chair
        route = ChairRoute.of_chair(profile, start.chair, motion.chair_goal.pose)
        chair = route.duration(profile, motion.timing)
    return Durations(hand, chair, _for_joints(path, start, motion.timing.peak))


def _for_joints(path: Path, start: Configuration, peak: float) -> float:
    """Walk the path with the rates that are least for their limits; give what the worst needs.

    A place where the walk loses the path says nothing: no duration would help there.
    """
    at, free = start, start.body.top_rates**2
    worst = 0.0
    for look in range(1, LOOKS + 1):
        wanted = path.pose(look / LOOKS)
        asked = pose_error(at.hand, wanted)
        columns = at.jacobian * free
        square = columns @ at.jacobian.T + FLOOR * np.eye(6)
        change = np.linalg.solve(square, asked) @ columns
        at = at.moved(change, 1.0)
        left = pose_error(at.hand, wanted)
        if np.linalg.norm(left) <= LOST * np.linalg.norm(asked):
            worst = max(worst, float((np.abs(change) / start.body.top_rates).max()))
    return worst * LOOKS * peak
