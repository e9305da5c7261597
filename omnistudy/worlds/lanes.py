"""Routes as lanes beside each other, so that drawn routes do not hide each other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import dist

import numpy as np

from omnistudy.worlds.obstacles import Points
from omnistudy.worlds.route import Point
from omnistudy.worlds.way import joined
from omnistudy.worlds.world import World

SPACING = 0.08
"""Distance in m between two lanes; the way out and the way back are on opposite sides."""

SHARPEST = 0.3
"""1 + cosine of the corner below which a lane turns back instead of being mitred."""


def lanes(world: World) -> tuple[Points, ...]:
    """Give a line (n, 2) in m for each route, to the right of its way, each on its own lane.

    A single route that never comes back the same way stays in the middle.
    """
    ways = [joined(route) for route in world.routes]
    if len(ways) == 1 and not any(_turns_back(*three) for three in _threes(ways[0])):
        return (np.array(ways[0]),)
    return tuple(_shifted(way, SPACING * (place + 1)) for place, way in enumerate(ways))


def _shifted(way: Sequence[Point], aside: float) -> Points:
    """Shift a way to its right; at a way back it crosses over to the other side."""
    rights = [_right(start, end) for start, end in pairwise(way)]
    line = [np.add(way[0], aside * rights[0])]
    for point, (before, after) in zip(way[1:-1], pairwise(rights), strict=True):
        sharpness = 1.0 + float(before @ after)
        if sharpness < SHARPEST:
            line += [np.add(point, aside * before), np.add(point, aside * after)]
        else:
            line.append(np.add(point, aside * (before + after) / sharpness))
    line.append(np.add(way[-1], aside * rights[-1]))
    return np.array(line)


def _right(start: Point, end: Point) -> Points:
    length = dist(start, end)
    return np.array([(end[1] - start[1]) / length, (start[0] - end[0]) / length])


def _turns_back(before: Point, here: Point, after: Point) -> bool:
    return 1.0 + float(_right(before, here) @ _right(here, after)) < SHARPEST


def _threes(way: Sequence[Point]) -> list[tuple[Point, Point, Point]]:
    return list(zip(way, way[1:], way[2:], strict=False))
