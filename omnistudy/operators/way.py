"""Where on the way a driver is, and what lies ahead on it."""

from __future__ import annotations

import itertools
from math import hypot

from omnistudy.worlds import Leg

LOOK_BACK, LOOK_AHEAD = 0.3, 1.0
"""A driver finds himself again within this much of where he was, m along the way."""


class Way:
    """A leg as an arc length; the driver's place on it only moves with the driver."""

    __slots__ = ("_ends", "_points", "_starts", "length", "place")

    def __init__(self, leg: Leg) -> None:
        points = [leg.path[0]]
        for point in leg.path[1:]:
            if point != points[-1]:
                points.append(point)
        self._points = tuple(points)
        starts, s = [], 0.0
        for (ax, ay), (bx, by) in itertools.pairwise(points):
            starts.append(s)
            s += hypot(bx - ax, by - ay)
        self._starts = tuple(starts)
        self._ends = (*self._starts[1:], s)
        self.length = s
        self.place = 0.0

    def find(self, x: float, y: float) -> float:
        """Move the place to the nearest point of the way to (x, y), not far from the last one."""
        self.place = self.nearest(x, y, self.place - LOOK_BACK, self.place + LOOK_AHEAD)
        return self.place

    def nearest(self, x: float, y: float, low: float, high: float) -> float:
        """Give the arc length in [low, high] of the point nearest to (x, y), m."""
        best, best_squared = self.place, float("inf")
        for i, (start, end) in enumerate(zip(self._starts, self._ends, strict=True)):
            if end < low or start > high:
                continue
            ax, ay = self._points[i]
            bx, by = self._points[i + 1]
            length = end - start
            ux, uy = (bx - ax) / length, (by - ay) / length
            along = (x - ax) * ux + (y - ay) * uy
            along = max(0.0, low - start, min(length, high - start, along))
            dx, dy = ax + along * ux - x, ay + along * uy - y
            squared = dx * dx + dy * dy
            if squared < best_squared:
                best, best_squared = start + along, squared
        return best

    def at(self, s: float) -> tuple[float, float]:
        """Give the point at arc length s, m; the ends stand for what lies beyond them."""
        s = max(0.0, min(self.length, s))
        for i, end in enumerate(self._ends):
            if s <= end:
                ax, ay = self._points[i]
                bx, by = self._points[i + 1]
                share = (s - self._starts[i]) / (end - self._starts[i])
                return ax + share * (bx - ax), ay + share * (by - ay)
        return self._points[-1]
