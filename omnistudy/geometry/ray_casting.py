"""Exact ranges to straight walls in the plane, for scans that need no physics."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from omnistudy.geometry.planar import PlanarPose
from omnistudy.geometry.scan import Scan

Segment = tuple[tuple[float, float], tuple[float, float]]
"""A wall without thickness: its two ends (x, y) in m, world coordinates."""


def cast(
    walls: Sequence[Segment], pose: PlanarPose, angles: NDArray[np.float64], max_range: float
) -> Scan:
    """Give the scan of a sensor at `pose` between walls.

    angles : (n,) rad, robot frame. max_range : m, held by rays that meet nothing nearer.
    A wall seen exactly edge-on is not seen.
    """
    nearest = np.full(angles.shape, max_range)
    x, y = np.cos(angles + pose.theta), np.sin(angles + pose.theta)
    for (from_x, from_y), (to_x, to_y) in walls:
        along_x, along_y = to_x - from_x, to_y - from_y
        start_x, start_y = from_x - pose.x, from_y - pose.y
        turn = x * along_y - y * along_x
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = (start_x * along_y - start_y * along_x) / turn
            place = (start_x * y - start_y * x) / turn
        met = (turn != 0.0) & (distance >= 0.0) & (place >= 0.0) & (place <= 1.0)
        nearest = np.where(met, np.minimum(nearest, distance), nearest)
    return Scan(angles, nearest, max_range)
