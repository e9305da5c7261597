"""Scans of endless straight walls, for the tests of laws; shares nothing with the ray caster."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin

import numpy as np

from omnistudy.geometry import Scan

RAYS = tuple(-pi + i * pi / 64 for i in range(128))
"""Angles of the published lidar, rad."""

Wall = tuple[float, float, float]
"""(a, b, c): all points with a·x + b·y = c, robot frame, m, c above zero."""


def scan_of(walls: Sequence[Wall], max_range: float = 0.6) -> Scan:
    """Give what the published lidar sees of the nearest of some endless walls."""
    return Scan(
        np.array(RAYS), np.array([_nearest(walls, ray, max_range) for ray in RAYS]), max_range
    )


def _nearest(walls: Sequence[Wall], ray: float, max_range: float) -> float:
    towards = [(a * cos(ray) + b * sin(ray), c) for a, b, c in walls]
    return min([c / speed for speed, c in towards if speed > 1e-9], default=max_range)


def few_rays(pairs: Sequence[tuple[tuple[float, float], float]], max_range: float = 0.6) -> Scan:
    """Give a scan of rays ((cos, sin), range), for scenes that a person can work out."""
    return Scan(
        np.array([np.arctan2(sine, cosine) for (cosine, sine), _ in pairs]),
        np.array([distance for _, distance in pairs]),
        max_range,
    )
