"""The boundary of the force field around the robot, and what reaches into it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import lru_cache
from typing import Annotated, Literal, NamedTuple

import numpy as np
from annotated_types import Ge
from numpy.typing import NDArray
from pydantic import BeforeValidator, Field

from omnistudy.geometry import Scan
from omnistudy.registry import KindModel
from omnistudy.units import Metres, Positive

Floats = NDArray[np.float64]

CENTRE: Floats = np.zeros((1, 2))
"""Where the rays of a scan without origins start."""


class Penetrations(NamedTuple):
    """The rays that detect something inside the boundary, all arrays (n,).

    rays : place of each in the scan.
    depth : m, from the obstacle out to the boundary along the ray, above zero.
    distance : m, from where the ray starts to the obstacle.
    origins : (n, 2) m, robot frame, where each ray starts; None for the robot's centre.
    """

    rays: NDArray[np.intp]
    depth: Floats
    distance: Floats
    origins: Floats | None = None


class Boundary(KindModel, ABC):
    """A line around the robot inside which obstacles push."""

    @abstractmethod
    def reach(self, angles: Floats, origins: Floats = CENTRE) -> Floats:
        """Give how far along each ray the boundary lies, in m; zero for a ray from outside.

        angles : (n,) rad. origins : (n, 2) or (1, 2) m, robot frame.
        """

    def penetrations(self, scan: Scan) -> Penetrations | None:
        """Give what lies inside the boundary, or None when nothing does.

        A range that is not a number, not above zero, or not below the sensor's `max_range` is no
        detection, nor is anything on a ray that starts outside the boundary.
        """
        angles = np.asarray(scan.angles, np.float64).tobytes()
        starts = None if scan.origins is None else np.asarray(scan.origins, np.float64).tobytes()
        reach, limit = _limits(self, angles, starts, scan.max_range)
        rays = np.flatnonzero((scan.ranges < limit) & (scan.ranges > 0.0))
        if rays.size == 0:
            return None
        distance = scan.ranges[rays]
        origins = None if scan.origins is None else scan.origins[rays]
        return Penetrations(rays, reach[rays] - distance, distance, origins)


def boundary_of(law: object) -> Boundary | None:
    """Give the boundary of a law, or None for a law without one."""
    boundary = getattr(law, "boundary", None)
    return boundary if isinstance(boundary, Boundary) else None


@lru_cache(maxsize=64)
def _limits(
    boundary: Boundary, angles: bytes, starts: bytes | None, max_range: float
) -> tuple[Floats, Floats]:
    """Give the boundary's reach and the range below which a ray counts; scans repeat angles."""
    origins = CENTRE if starts is None else np.frombuffer(starts).reshape(-1, 2)
    reach = boundary.reach(np.frombuffer(angles), origins)
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

    def reach(self, angles: Floats, origins: Floats = CENTRE) -> Floats:
        """Give min(X/|cos a|, Y/|sin a|) from the centre, X and Y half sizes with layers, in m.

        From elsewhere X and Y are what is left of them on the side that the ray looks to.
        """
        length, width = self.half_length + self.layer_x, self.half_width + self.layer_y
        cos, sin, (x, y) = np.cos(angles), np.sin(angles), origins.T
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            ahead = (length - x * np.sign(cos)) / np.abs(cos)
            aside = (width - y * np.sign(sin)) / np.abs(sin)
        inside = (np.abs(x) < length) & (np.abs(y) < width)
        return np.where(inside, np.minimum(ahead, aside), 0.0)


class CircularBoundary(Boundary):
    """The same distance all round, as fields with a circular boundary (Tyagi 2017, sec. 2.4)."""

    kind: Literal["circular"] = "circular"

    radius: Annotated[Metres, Positive] = 0.5
    """From the robot's centre; ours: the thesis gives none."""

    def reach(self, angles: Floats, origins: Floats = CENTRE) -> Floats:
        """Give the distance to the circle along each ray: the radius, from the centre, in m."""
        x, y = origins.T
        towards = x * np.cos(angles) + y * np.sin(angles)
        left = self.radius**2 - (x * x + y * y)
        inside = left > 0.0
        return np.where(inside, np.sqrt(towards**2 + np.where(inside, left, 0.0)) - towards, 0.0)


def _with_kind(given: object) -> object:
    """Read a boundary's page without `kind` as a rectangle's, which is every law's default."""
    return {"kind": "rectangular", **given} if isinstance(given, dict) else given


AnyBoundary = Annotated[
    RectangularBoundary | CircularBoundary,
    BeforeValidator(_with_kind),
    Field(discriminator="kind"),
]
"""What a law's `boundary:` may hold, told apart by `kind`."""
