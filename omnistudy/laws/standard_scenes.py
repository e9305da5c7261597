"""Four small scenes in which laws are set side by side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from omnistudy.geometry import PlanarPose, Scan
from omnistudy.geometry.ray_casting import Segment, cast

RAYS: NDArray[np.float64] = -pi + np.arange(128, dtype=np.float64) * (pi / 64.0)
"""Angles of the published lidar, rad (Tyagi 2017, sec. 2.4)."""

MAX_RANGE = 0.6
"""m, beyond the farthest corner of the published boundary (0.538 m)."""

VIEW = (2.4, 1.3)
"""Width and height in m of what a picture shows of each scene."""


@dataclass(frozen=True, slots=True)
class StandardScene:
    """Walls, and the rectangle in which a robot that faces +x is put on a grid.

    x, y : first and last place of the robot's centre in m.
    middle : of the view, in m.
    shown : place in m at which the robot itself is drawn.
    """

    title: str
    walls: tuple[Segment, ...]
    x: tuple[float, float]
    y: tuple[float, float]
    middle: tuple[float, float]
    shown: tuple[float, float]

    def scans(self, step: float) -> Iterator[tuple[PlanarPose, Scan]]:
        """Give pose and scan at every place of a grid with `step` in m between places."""
        for y in _places(*self.y, step):
            for x in _places(*self.x, step):
                pose = PlanarPose(x, y, 0.0)
                yield pose, cast(self.walls, pose, RAYS, MAX_RANGE)


def _places(first: float, last: float, step: float) -> list[float]:
    return [first + i * step for i in range(round((last - first) / step) + 1)]


STANDARD_SCENES = (
    StandardScene(
        "beside a wall",
        (((-0.6, 0.0), (0.6, 0.0)),),
        x=(-1.0, 1.0),
        y=(-0.6, -0.2),
        middle=(0.0, -0.4),
        shown=(-0.7, -0.3),
    ),
    StandardScene(
        "in front of a short wall",
        (((0.0, -0.3), (0.0, 0.3)),),
        x=(-0.6, -0.3),
        y=(-0.5, 0.5),
        middle=(-0.4, 0.0),
        shown=(-0.4, 0.3),
    ),
    StandardScene(
        "in an L corner",
        (((0.0, 0.0), (0.0, -1.4)), ((0.0, 0.0), (-1.7, 0.0))),
        x=(-1.2, -0.3),
        y=(-0.9, -0.2),
        middle=(-0.7, -0.45),
        shown=(-0.4, -0.3),
    ),
    StandardScene(
        "into a corridor of 1 m",
        (((0.0, 0.5), (1.4, 0.5)), ((0.0, -0.5), (1.4, -0.5))),
        x=(-0.8, 0.9),
        y=(-0.3, 0.3),
        middle=(0.1, 0.0),
        shown=(-0.2, 0.2),
    ),
)
