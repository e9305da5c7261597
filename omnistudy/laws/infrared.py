"""The law of the thesis's first robot: six infrared sensors, a spring and a damper on each."""

from __future__ import annotations

from functools import lru_cache
from math import cos, pi, sin
from typing import Annotated, Literal

import numpy as np
from annotated_types import Ge, Le
from numpy.typing import NDArray

from omnistudy.geometry import PlanarTwist, PlanarWrench, Scan
from omnistudy.laws.boundary import AnyBoundary, RectangularBoundary
from omnistudy.laws.law import WrenchLaw
from omnistudy.units import Metres, NewtonSecondsPerMetre, NewtonsPerMetre, Radians

Floats = NDArray[np.float64]

WIDEST_MISS = pi / 8.0
"""rad between a sensor and the nearest ray at which the sensor sees nothing (ours)."""

_SAME = 1e-9
"""rad within which rays look the same way."""


class InfraredLaw(WrenchLaw):
    """Springs and dampers of six infrared sensors, summed (Tyagi 2017, sec. 2.3, eq. 2.4-2.6).

    wrench = K·(x0 - x) + B·w: x is what each sensor reads, x0 what it reads at the boundary (eq.
    2.6 has no x0), w how fast it closes in. Sensor 1 looks left, 2 ahead on the left, 3 and 4
    ahead, 5 ahead on the right, 6 right; entry (1, 5) of K and B is read with a minus, so that 5
    mirrors 2. A sensor that sees nothing inside the boundary gives nothing, its damper included.

    Each sensor reads the scan's ray that is nearest to its direction, or the mean of those equally
    near: of the six-sensor robot its own ray, in whatever order they come, and of any other scan
    six rays. w is -`Scan.rates`; on a scan without rates it is what the twist makes of a still wall
    square to the sensor's line of action.
    """

    kind: Literal["infrared"] = "infrared"

    boundary: AnyBoundary = RectangularBoundary(half_length=0.20, half_width=0.18)
    """Where the springs begin; by default round a Nexus robot of 0.40 by 0.36 m."""

    stiffness: Annotated[NewtonsPerMetre, Ge(0.0)] = 20.0
    """k of each sensor. Ours: 80 N/m from a wall ahead, which four sensors see, against which the
    published stick, pushed by a steady force and nothing else, comes to rest. At 50 it shakes."""

    damping: Annotated[NewtonSecondsPerMetre, Ge(0.0)] = 1.2
    """d of each sensor. Ours, the larger the more the stick is slowed in front of a wall."""

    oblique_angle: Annotated[Radians, Ge(0.0), Le(pi / 2.0)] = pi / 4.0
    """Theta of eq. 2.4: of sensors 2 and 5 from the side to the front. Ours: the figure is lost."""

    oblique_ahead: Metres = 0.20
    """a of eq. 2.4: sensors 2 and 5 ahead of the robot's centre. Ours: its front edge."""

    oblique_aside: Metres = 0.10
    """b of eq. 2.4: sensors 2 and 5 to the side of the robot's centre. Ours."""

    def wrench(self, scan: Scan, twist: PlanarTwist) -> PlanarWrench:
        """Give the sum over the sensors in N, N, N·m, unclipped."""
        inside = self.boundary.penetrations(scan)
        if inside is None:
            return PlanarWrench(0.0, 0.0, 0.0)
        lines = _lines(self.oblique_angle, self.oblique_ahead, self.oblique_aside)
        readings = _readings(np.asarray(scan.angles, np.float64).tobytes(), self.oblique_angle)
        seen = readings[:, inside.rays]
        if scan.rates is None:
            closing = seen.sum(axis=1) * (lines.T @ twist)
        else:
            closing = seen @ -scan.rates[inside.rays]
        push = lines @ (self.stiffness * (seen @ inside.depth) + self.damping * closing)
        return PlanarWrench(*(0.0 - float(part) for part in push))


def sensor_directions(oblique_angle: float) -> tuple[float, ...]:
    """Give where sensors 1 to 6 look, rad from straight ahead, counter-clockwise."""
    oblique = pi / 2.0 - oblique_angle
    return pi / 2.0, oblique, 0.0, 0.0, -oblique, -pi / 2.0


@lru_cache(maxsize=64)
def _lines(angle: float, ahead: float, aside: float) -> Floats:
    """Give -K/k: (3, 6), the wrench of a unit force toward what each sensor sees.

    Its transpose takes a twist to the speed along each line, so that dampers only ever brake.
    """
    arm = ahead * cos(angle) - aside * sin(angle)
    return np.array(
        [
            [0.0, sin(angle), 1.0, 1.0, sin(angle), 0.0],
            [1.0, cos(angle), 0.0, 0.0, -cos(angle), -1.0],
            [0.0, arm, 0.0, 0.0, -arm, 0.0],
        ]
    )


@lru_cache(maxsize=64)
def _readings(angles: bytes, oblique_angle: float) -> Floats:
    """Give (6, n): how much each ray counts in what each sensor reads; scans repeat angles."""
    rays = np.frombuffer(angles)
    directions = np.array(sensor_directions(oblique_angle))[:, np.newaxis]
    miss = np.abs(np.arctan2(np.sin(rays - directions), np.cos(rays - directions)))
    nearest = miss.min(axis=1, keepdims=True)
    chosen = (miss <= nearest + _SAME) & (nearest < WIDEST_MISS)
    weights: Floats = chosen / np.maximum(1, chosen.sum(axis=1, keepdims=True))
    return weights
