"""What is measured along a way through walls: points, heading changes, free width."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import atan2, degrees, dist, inf

import numpy as np

from omnistudy.geometry import wrapped
from omnistudy.worlds.obstacles import Obstacles, Points
from omnistudy.worlds.route import Leg, Point, Route

STEP = 0.01
"""Distance in m between the points at which a way is measured."""

SAME = 0.01
"""Distance in m below which two corners of a way are one."""


def narrowest(leg: Leg, walls: Obstacles) -> tuple[float, Point]:
    """Give the least free width across a leg, and where.

    The width at a point is the distance to the nearest wall on the left plus that on the right;
    walls ahead and behind (within 45 deg of the way) bound no passage.
    """
    best = (inf, leg.path[0])
    for start, end in _segments(leg.path):
        way = np.subtract(end, start) / dist(start, end)
        for points in walls.pieces(_between(start, end)):
            vectors, distances = walls.towards(points)
            ahead = np.abs(vectors @ way)
            aside = vectors @ np.array((-way[1], way[0]))
            left = np.where(aside >= ahead, distances, inf).min(axis=1, initial=inf)
            right = np.where(-aside >= ahead, distances, inf).min(axis=1, initial=inf)
            widths = np.maximum(left, 0.0) + np.maximum(right, 0.0)
            index = int(widths.argmin())
            if widths[index] < best[0]:
                x, y = points[index].tolist()
                best = (float(widths[index]), (x, y))
    return best


def joined(route: Route) -> list[Point]:
    """Join the legs to one line without points that repeat."""
    way: list[Point] = []
    for leg in route.legs:
        for point in leg.path:
            if not way or dist(way[-1], point) > SAME:
                way.append(point)
    return way


def heading_changes(way: list[Point]) -> list[float]:
    """Give how far the heading changes, in degrees, at each inner point."""
    headings = [atan2(b[1] - a[1], b[0] - a[0]) for a, b in _segments(way)]
    return [abs(degrees(wrapped(after - before))) for before, after in pairwise(headings)]


def _segments(line: Sequence[Point]) -> Iterator[tuple[Point, Point]]:
    for start, end in pairwise(line):
        if start != end:
            yield start, end


def sampled(leg: Leg) -> Points:
    """Give points (n, 2) along a leg, at most STEP apart, its corners among them."""
    return np.concatenate([_between(start, end) for start, end in _segments(leg.path)])


def _between(start: Point, end: Point) -> Points:
    count = int(dist(start, end) / STEP) + 2
    return np.linspace(start, end, count)


def steps(low: float, high: float) -> Points:
    """Give the numbers from `low` to `high`, at most STEP apart."""
    return np.linspace(low, high, int((high - low) / STEP) + 2)
