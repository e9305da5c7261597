"""What moving bodies do to a world: where they come past, and for how long they close a way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, dist
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.scene import Body, Box
from omnistudy.worlds.obstacles import Obstacles, Points, obstacles
from omnistudy.worlds.route import Route
from omnistudy.worlds.way import sampled
from omnistudy.worlds.world import World

APART = 0.02
"""Distance in m between two places at which a moving body is looked at."""

EVERY = 5
"""Of the points of a way, each so many is looked at: every 5 cm."""

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
        for met in _meetings(route, sweep, width):
            if not met.for_good:
                yield f"{met.where} is in the way for {met.closed:.1f} s of {_whole(sweep)}"


def closures(route: Route, swept: tuple[Sweep, ...], width: float) -> Iterator[str]:
    """Say where a body closes a route for good."""
    for sweep in swept:
        for met in _meetings(route, sweep, width):
            if met.for_good:
                yield f"{met.where} never leaves the way"


def through_walls(swept: tuple[Sweep, ...], walls: Obstacles) -> Iterator[str]:
    """Say which bodies go through walls, which do not stop them."""
    for sweep in swept:
        shape = sweep.body.geometry
        half = min(shape.x, shape.y) / 2 if isinstance(shape, Box) else shape.radius
        inside = walls.distances(sweep.places.centres) < half - ROUNDING
        for index in np.flatnonzero(inside.any(axis=0))[:1]:
            yield f"'{sweep.body.name}' moves through wall '{walls.names[index]}'"


class _Meeting(NamedTuple):
    """Where a body is in the way of a leg, for how many s, and whether for good."""

    where: str
    closed: float
    for_good: bool


def _meetings(route: Route, sweep: Sweep, width: float) -> Iterator[_Meeting]:
    for leg in route.legs:
        points = sampled(leg)[::EVERY]
        distances = sweep.places.distances(points)
        near = distances <= width / 2
        if near.any():
            always = near.all(axis=1).any()
            stays = not _repeats(sweep) and near[:, -1].any()
            x, y = points[int(distances.min(axis=1).argmin())]
            yield _Meeting(
                f"route '{route.name}', leg to '{leg.target}', at ({x:.2f}, {y:.2f}): "
                f"'{sweep.body.name}'",
                float(sweep.durations[near.any(axis=0)].sum()),
                bool(always or stays),
            )


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
    for (begin, a), (end, b) in pairwise(zip(track.times, track.places, strict=True)):
        count = max(1, ceil(dist(a, b) / APART))
        shares = np.append((np.arange(count) + 0.5) / count, 1.0)
        places.append(np.outer(1.0 - shares, a) + np.outer(shares, b))
        durations.append(np.append(np.full(count, (end - begin) / count), 0.0))
    centres = np.concatenate(places)
    plan = obstacles([body.model_copy(update={"motion": None})])
    repeated = Obstacles(
        plan.names * len(centres),
        centres,
        np.repeat(plan.along, len(centres), axis=0),
        np.repeat(plan.halves, len(centres), axis=0),
        np.repeat(plan.radii, len(centres)),
    )
    return Sweep(body, repeated, np.concatenate(durations))
