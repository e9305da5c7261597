"""What moving bodies do to a world: where they come past, and for how long they close a way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, dist

import numpy as np
from numpy.typing import NDArray

from omnistudy.scene import Body, Box
from omnistudy.worlds.obstacles import Obstacles, Points, obstacles
from omnistudy.worlds.route import Route
from omnistudy.worlds.way import sampled
from omnistudy.worlds.world import World

APART = 0.05
"""Distance in m between two places at which a moving body is looked at."""

EVERY = 5
"""Of the points of a way, each so many is looked at: again 5 cm."""

ROUNDING = 0.01
"""Depth in m up to which a body that slides along a wall does not go through it."""


@dataclass(frozen=True, slots=True, eq=False)
class Sweep:
    """A moving body at k moments of its course.

    places : the body as k obstacles. durations : (k,) s that each stands for; their sum is what
    happens before everything repeats, or before the body stays for good.
    """

    body: Body
    places: Obstacles
    durations: Points


def sweeps(world: World) -> tuple[Sweep, ...]:
    """Look at every moving body along its whole course."""
    return tuple(_sweep(body) for body in world.scene.moving)


def in_reach(sweep: Sweep, points: Points, radius: float) -> NDArray[np.bool_]:
    """Tell (n, k) whether a point is within `radius` m of the body at a moment."""
    return sweep.places.distances(points) <= radius


def crossings(route: Route, swept: tuple[Sweep, ...], width: float) -> Iterator[str]:
    """Say where and for how long each body is in a route's way, if it is not for good."""
    for sweep in swept:
        for target, points, near in _met(route, sweep, width):
            if near.any() and not _for_good(sweep, near):
                closed = float(sweep.durations[near.any(axis=0)].sum())
                x, y = points[int((near @ sweep.durations).argmax())]
                yield (
                    f"route '{route.name}', leg to '{target}', at ({x:.2f}, {y:.2f}): "
                    f"'{sweep.body.name}' is in the way for {closed:.1f} s of "
                    f"{_whole(sweep)}"
                )


def closures(route: Route, swept: tuple[Sweep, ...], width: float) -> Iterator[str]:
    """Say where a body closes a route for good."""
    for sweep in swept:
        for target, points, near in _met(route, sweep, width):
            if _for_good(sweep, near):
                worst = int((near @ sweep.durations).argmax())
                if not _repeats(sweep):
                    worst = int(near[:, -1].argmax())
                x, y = points[worst]
                yield (
                    f"route '{route.name}', leg to '{target}', at ({x:.2f}, {y:.2f}): "
                    f"'{sweep.body.name}' never leaves the way"
                )


def through_walls(swept: tuple[Sweep, ...], walls: Obstacles) -> Iterator[str]:
    """Say which bodies go through walls, which do not stop them."""
    for sweep in swept:
        shape = sweep.body.geometry
        half = min(shape.x, shape.y) / 2 if isinstance(shape, Box) else shape.radius
        inside = walls.distances(sweep.places.centres) < half - ROUNDING
        for index in np.flatnonzero(inside.any(axis=0))[:1]:
            yield f"'{sweep.body.name}' moves through wall '{walls.names[index]}'"


def _met(
    route: Route, sweep: Sweep, width: float
) -> Iterator[tuple[str, Points, NDArray[np.bool_]]]:
    for leg in route.legs:
        points = sampled(leg)[::EVERY]
        yield leg.target, points, in_reach(sweep, points, width / 2)


def _for_good(sweep: Sweep, near: NDArray[np.bool_]) -> bool:
    """Tell whether a point is never free, or not any more once the body has arrived."""
    return bool(near.all(axis=1).any() or (not _repeats(sweep) and near[:, -1].any()))


def _repeats(sweep: Sweep) -> bool:
    track = sweep.body.track
    return track is not None and track.repeats


def _whole(sweep: Sweep) -> str:
    duration = float(sweep.durations.sum())
    return f"every {duration:.1f} s" if _repeats(sweep) else f"the first {duration:.1f} s"


def _sweep(body: Body) -> Sweep:
    track = body.track
    assert track is not None
    places, durations = [], []
    stops = zip(track.times, track.places, strict=True)
    for (begin, a), (end, b) in pairwise(stops):
        count = ceil(dist(a, b) / APART) + 1
        shares = np.linspace(0.0, 1.0, count) if count > 1 else np.zeros(1)
        places += [(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])) for s in shares.tolist()]
        durations += [(end - begin) / count] * count
    still = [
        body.model_copy(update={"x": x, "y": y, "motion": None, "name": body.name})
        for x, y in places
    ]
    return Sweep(body, obstacles(still), np.array(durations))
