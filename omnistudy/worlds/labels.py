"""Where the name of a region is written: beside it, clear of walls and ways."""

from __future__ import annotations

from itertools import pairwise
from math import dist, inf
from typing import NamedTuple

import numpy as np

from omnistudy.scene import Region
from omnistudy.worlds.obstacles import obstacles
from omnistudy.worlds.route import Point
from omnistudy.worlds.way import sampled
from omnistudy.worlds.world import World

GAP = 0.15
"""Distance in m between a region's edge and its name."""

HALF_TEXT = 0.5
"""Half of what a name takes up, in m."""

ENOUGH = 0.6
"""Free space in m round a name's middle above which more is no better."""


class LabelPlace(NamedTuple):
    """Where a name stands and to which side of that point it runs."""

    at: Point
    horizontal: str
    vertical: str


def label_place(region: Region, world: World) -> LabelPlace:
    """Give the place beside the region's longest edge that is clear of all else."""
    walls = obstacles(world.scene.bodies)
    legs = [sampled(leg) for route in world.routes for leg in route.legs]
    ways = np.concatenate((np.empty((0, 2)), *legs))
    best, best_score = LabelPlace(region.polygon[0], "center", "center"), (-inf, -inf)
    for start, end in pairwise((*region.polygon, region.polygon[0])):
        x, y = _outward(region, start, end)
        middle = np.array([_beside(start, end, (x, y), GAP + HALF_TEXT * (abs(x) or 0.4))])
        free = min(
            float(walls.distances(middle).min(initial=inf)),
            float(np.hypot(*(ways - middle).T).min(initial=inf)),
        )
        score = (min(free, ENOUGH), dist(start, end))
        if score > best_score:
            at = _beside(start, end, (x, y), GAP)
            best, best_score = (
                LabelPlace(at, _side(x, "left", "right"), _side(y, "bottom", "top")),
                score,
            )
    return best


def _outward(region: Region, start: Point, end: Point) -> Point:
    """Give the unit vector across an edge that leaves the region."""
    length = dist(start, end)
    across = ((end[1] - start[1]) / length, (start[0] - end[0]) / length)
    inside = region.contains(*_beside(start, end, across, 0.01))
    return (-across[0], -across[1]) if inside else across


def _beside(start: Point, end: Point, across: Point, gap: float) -> Point:
    return (
        (start[0] + end[0]) / 2 + gap * across[0],
        (start[1] + end[1]) / 2 + gap * across[1],
    )


def _side(component: float, positive: str, negative: str) -> str:
    if abs(component) < 0.5:
        return "center"
    return positive if component > 0 else negative
