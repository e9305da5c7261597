"""The law of a wheelchair with a ring of ultrasonic sensors, each pushing by one over distance."""

from __future__ import annotations

from math import cos, pi, sin
from typing import Annotated, Literal

import numpy as np
from annotated_types import Ge, Len
from numpy.typing import NDArray

from omnistudy.geometry import ZERO_MATRIX, Matrix3, PlanarTwist, PlanarWrench, Scan
from omnistudy.laws.boundary import AnyBoundary, CircularBoundary
from omnistudy.laws.law import WrenchLaw
from omnistudy.units import Metres, NewtonMetres, Positive

Floats = NDArray[np.float64]

SECTORS = 16
"""Ultrasonic sensors of that wheelchair (eq. 1.8)."""

_AXES = [i * 2.0 * pi / SECTORS for i in range(SECTORS)]
"""Where each sensor looks, rad; the first straight ahead, then counter-clockwise (ours)."""

_COSINES: Floats = np.array([[cos(axis)] for axis in _AXES])
_SINES: Floats = np.array([[sin(axis)] for axis in _AXES])

_LEAST_COSINE = cos(pi / SECTORS) - 1e-12
"""Of half a sector; what lies on the border of two sectors is seen by both sensors."""


class SectorSumLaw(WrenchLaw):
    """Away from what each of 16 sensors sees, by one over its distance, summed.

    F = sum of alpha·(1/d)·e^(j(pi + theta)) (Fattouh et al. 2004 after Tyagi 2017, sec. 1.5,
    eq. 1.8-1.9). d is the distance from the robot's centre to the nearest obstacle that a sector
    sees inside the boundary. theta is the direction of the sector's middle, for an ultrasonic
    sensor does not tell where in its cone an echo came from (ours). The force is not zero where an
    obstacle comes in, but jumps to alpha over the distance of the boundary there.
    """

    kind: Literal["sector_sum"] = "sector_sum"

    boundary: AnyBoundary = CircularBoundary()
    """How far the sensors see."""

    weights: Annotated[
        tuple[Annotated[NewtonMetres, Ge(0.0)], ...], Len(min_length=SECTORS, max_length=SECTORS)
    ] = (0.5,) * SECTORS
    """alpha of each sector, newtons times metres, the first straight ahead, then counter-clockwise.
    Ours: all equal, and 7 N for the published robot that touches a wall ahead."""

    blind_distance: Annotated[Metres, Positive] = 0.02
    """What is nearer to the robot's centre counts as if it were so near (ours)."""

    def wrench(self, scan: Scan, twist: PlanarTwist) -> PlanarWrench:
        """Give the force in N, unclipped, and no torque; how the stick moves is nothing to it."""
        inside = self.boundary.penetrations(scan)
        if inside is None:
            return PlanarWrench(0.0, 0.0, 0.0)
        x, y = scan.points()[inside.rays].T
        distance = np.hypot(x, y)
        seen = _COSINES * x + _SINES * y >= _LEAST_COSINE * distance
        nearest = np.where(seen, np.maximum(distance, self.blind_distance), np.inf).min(axis=1)
        push = np.array(self.weights) / nearest
        fx, fy = push @ _COSINES, push @ _SINES
        return PlanarWrench(0.0 - fx.item(), 0.0 - fy.item(), 0.0)

    def twist_gradient(self, scan: Scan, twist: PlanarTwist) -> Matrix3:
        """Give zeros: there is no damper."""
        return ZERO_MATRIX
