"""The boundary of the force field around the robot, and what reaches into it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import lru_cache
from typing import Annotated, Literal, NamedTuple

import numpy as np
from annotated_types import Ge
from numpy.typing import NDArray

from omnistudy.geometry import Scan
from omnistudy.registry import KindModel
from omnistudy.units import Metres, Positive

Floats = NDArray[np.float64]


class Penetrations(NamedTuple):
    """The rays that detect something inside the boundary, all arrays (n,).

    rays : place of each in the scan.
    depth : m, from the obstacle out to the boundary along the ray, above zero.
    distance : m, from the robot's centre to the obstacle.
    """

    rays: NDArray[np.intp]
    depth: Floats
    distance: Floats


class Boundary(KindModel, ABC):
    """A line around the robot inside which obstacles push."""

    @abstractmethod
    def reach(self, angles: Floats) -> Floats:
        """Give how far the boundary lies from the robot's centre at each angle in rad, in m."""

    def penetrations(self, scan: Scan) -> Penetrations | None:
        """Give what lies inside the boundary, or None when nothing does.

        A range that is not a number, not above zero, or not below the sensor's `max_range` is no
        detection.
        """
        angles = np.asarray(scan.angles, np.float64).tobytes()
        reach, limit = _limits(self, angles, scan.max_range)
        rays = np.flatnonzero((scan.ranges < limit) & (scan.ranges > 0.0))
        if rays.size == 0:
            return None
        distance = scan.ranges[rays]
        return Penetrations(rays, reach[rays] - distance, distance)


@lru_cache(maxsize=64)
def _limits(boundary: Boundary, angles: bytes, max_range: float) -> tuple[Floats, Floats]:
    """Give the boundary's reach and the range below which a ray counts; scans repeat angles."""
    reach = boundary.reach(np.frombuffer(angles))
    return reach, np.minimum(reach, max_range)


class RectangularBoundary(Boundary):
    """The robot's outline grown by a layer (Tyagi 2017, ch. 4, Fig. 4.1 and appendix B)."""

    kind: Literal["rectangular"] = "rectangular"

    half_length: Annotated[Metres, Positive] = 0.29
    """Half of the robot, front to back (appendix B)."""

    half_width: Annotated[Metres, Positive] = 0.19
    """Half of the robot, side to side (appendix B)."""

    layer_x: Annotated[Metres, Ge(0.0)] = 0.15
    """Thickness of the layer ahead and behind (appendix B)."""

    layer_y: Annotated[Metres, Ge(0.0)] = 0.12
    """Thickness of the layer at the sides (appendix B)."""

    def reach(self, angles: Floats) -> Floats:
        """Give min(X/|cos a|, Y/|sin a|), X and Y being half sizes with their layers, in m."""
        with np.errstate(divide="ignore", over="ignore"):
            ahead = (self.half_length + self.layer_x) / np.abs(np.cos(angles))
            aside = (self.half_width + self.layer_y) / np.abs(np.sin(angles))
        return np.minimum(ahead, aside)


AnyBoundary = RectangularBoundary
"""What a law's `boundary:` may hold; a second kind makes this a union told apart by `kind`."""
