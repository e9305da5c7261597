"""How a wheelchair on two driven wheels carries the arm's base over the floor.

The pose of the wheelchair is that of the arm's base above the floor, as in the thesis, not of the
axle: x, y in m, heading in rad.
"""

from __future__ import annotations

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.profile import Chair
from omnistudy.geometry import PlanarPose

Floats = NDArray[np.float64]

STRAIGHT = 2.2e-16
"""Turns smaller than this, rad, are driven as a straight line."""


def axle(chair: Chair, pose: PlanarPose) -> PlanarPose:
    """Give the pose of the axle's middle for a pose of the wheelchair."""
    x, y = pose.to_world(-chair.arm_x, -chair.arm_y)
    return PlanarPose(x, y, pose.theta)


def pose_of_axle(chair: Chair, middle: PlanarPose) -> PlanarPose:
    """Give the wheelchair's pose for a pose of the axle's middle."""
    x, y = middle.to_world(chair.arm_x, chair.arm_y)
    return PlanarPose(x, y, middle.theta)


def driven(chair: Chair, pose: PlanarPose, distance: float, turn: float) -> PlanarPose:
    """Let the axle's middle go along an arc: `distance` in m along it, `turn` in rad."""
    start = axle(chair, pose)
    half = 0.5 * turn
    chord = distance if abs(turn) <= STRAIGHT else distance * sin(half) / half
    heading = start.theta + half
    end = PlanarPose(
        start.x + chord * cos(heading), start.y + chord * sin(heading), start.theta + turn
    )
    return pose_of_axle(chair, end)


def base_frame(chair: Chair, pose: PlanarPose) -> Floats:
    """Give the arm's base as seen from the ground, (4, 4)."""
    c, s = cos(pose.theta), sin(pose.theta)
    return np.array(
        [
            [c, -s, 0.0, pose.x],
            [s, c, 0.0, pose.y],
            [0.0, 0.0, 1.0, chair.arm_height],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def hand_per_wheels(chair: Chair, heading: float, hand: tuple[float, float]) -> Floats:
    """Give J_c·J_W of eq. (5): the hand's twist in ground axes per wheel speed, (6, 2).

    hand : x, y from the arm's base in axes of the wheelchair, m.
    Columns are the left and the right wheel, in (m/s, rad/s) per rad/s.
    """
    rates = hand_per_rates(chair, heading, hand)
    return rates @ rates_per_wheels(chair)


def hand_per_rates(chair: Chair, heading: float, hand: tuple[float, float]) -> Floats:
    """Give the hand's twist in ground axes per drive (m/s) and turn (rad/s), (6, 2)."""
    c, s = cos(heading), sin(heading)
    x, y = chair.arm_x + hand[0], chair.arm_y + hand[1]
    return np.array(
        [[c, -(x * s + y * c)], [s, x * c - y * s], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 1.0]]
    )


def rates_per_wheels(chair: Chair) -> Floats:
    """Give drive (m/s) and turn (rad/s) per speed of the left and the right wheel, (2, 2).

    Eq. (6) in its general form: X' = l5/2 (left + right), phi' = l5/l1 (right - left).
    """
    half, turn = 0.5 * chair.wheel_radius, chair.wheel_radius / chair.track
    return np.array([[half, half], [-turn, turn]])
