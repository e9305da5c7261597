"""What the thesis's own code does where this project does otherwise (Tyagi 2017, appendix B)."""

from __future__ import annotations

from dataclasses import replace
from math import floor

import numpy as np
from numpy.typing import NDArray

from omnistudy.devices.stick_scale import FORCE_AT_FULL_DUTY, FULL_DUTY, TORQUE_AT_FULL_DUTY
from omnistudy.geometry import PlanarTwist, Scan

NEWTONS_PER_COUNT = FORCE_AT_FULL_DUTY / FULL_DUTY
"""N at the handle for one count of PWM in x and y (ch. 2: 13.5 N; 255 is the full duty)."""

NEWTON_METRES_PER_COUNT = TORQUE_AT_FULL_DUTY / FULL_DUTY
"""N·m at the handle for one count of PWM in theta (ch. 2: 4.4 N·m)."""

FAR_CLIP = 0.5
"""Range in m from which on that lidar sees nothing: less than the field's corner at 0.538 m."""


def clipped(scan: Scan) -> Scan:
    """Give the scan as a sensor would see it that reaches no farther than the published one."""
    return replace(scan, max_range=min(scan.max_range, FAR_CLIP))


def previous_angles(angles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give for each ray the angle of the ray before it, in rad; (n,) to (n,).

    That code resolves ray i with the angle of index i - 1; the first ray takes one more step back.
    """
    if angles.size < 2:
        return angles
    return np.concatenate(([2.0 * angles[0] - angles[1]], angles[:-1]))


def rounded_mean(mean: float) -> float:
    """Round a mean in m or m² as that code does: to 0.01 cm or 0.01 cm·m, halves up."""
    return floor(mean * 1e4 + 0.5) / 1e4


def rounded_twist(twist: PlanarTwist) -> PlanarTwist:
    """Round a twist as that code does: to 0.01 m/s and 0.01 rad/s, halves up.

    There a turn counts clockwise, so a half is rounded the other way in omega.
    """
    return PlanarTwist(
        floor(twist.vx * 100.0 + 0.5) / 100.0,
        floor(twist.vy * 100.0 + 0.5) / 100.0,
        -floor(-twist.omega * 100.0 + 0.5) / 100.0,
    )
