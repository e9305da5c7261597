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
"""Keeps the estimate finite where the arm is singular."""

LONGEST = 5.0
"""An estimate is at most this many times the hand's own duration."""


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
    return Durations(hand, chair, _for_joints(path, start, hand * motion.timing.peak, hand))


def _for_joints(path: Path, start: Configuration, per_share: float, hand: float) -> float:
    """Walk the path with the rates that are least for their limits; give what the worst needs.

    The rate at a place is its change per share, over the seconds per share at full speed.
    """
    at, free = start, start.body.top_rates**2
    worst = 0.0
    for look in range(1, LOOKS + 1):
        columns = at.jacobian * free
        square = columns @ at.jacobian.T + FLOOR * np.eye(6)
        change = np.linalg.solve(square, pose_error(at.hand, path.pose(look / LOOKS))) @ columns
        worst = max(worst, float((np.abs(change) / start.body.top_rates).max()) * LOOKS)
        at = at.moved(change, 1.0)
    peak = per_share / hand if hand > 0.0 else 0.0
    return min(worst * peak, LONGEST * hand)
