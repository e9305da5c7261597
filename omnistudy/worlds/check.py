"""Whether a robot of a certain size can drive a world's routes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import dist, inf, sqrt

import numpy as np

from omnistudy.errors import nearest
from omnistudy.errors.worlds import NoRoute
from omnistudy.scene import Body
from omnistudy.worlds.moving import Sweep, closures, crossings, in_reach, sweeps, through_walls
from omnistudy.worlds.obstacles import Obstacles, Points, obstacles
from omnistudy.worlds.route import Leg, Point, Route
from omnistudy.worlds.way import heading_changes, joined, narrowest, sampled, steps
from omnistudy.worlds.world import World

TURN = 20.0
"""Degrees of heading change from which a corner counts as a turn."""

REVERSAL = 150.0
"""Degrees of heading change from which a corner is a way back out of a dead end."""

JOINT = 0.01
"""Gap in m up to which two legs join."""

REACH = 0.5
"""Distance in m between the end of a leg and its target up to which a robot touches it."""

EQUAL = 0.02
"""Relative difference up to which routes are equally long."""


@dataclass(frozen=True, slots=True)
class RouteCheck:
    """What one route asks of a robot.

    length : m. turns : corners, without the reversals. reversals : ways back out of dead ends.
    narrowest : m, free width across the way at its narrowest, walls alone; None in the open.
    narrowest_at : where that is, m.
    """

    name: str
    length: float
    turns: int
    reversals: int
    narrowest: float | None
    narrowest_at: Point | None


@dataclass(frozen=True, slots=True)
class WorldCheck:
    """A world against a robot's size; a fault makes it undrivable, a warning does not.

    notes : what moving bodies do to the routes for a time.
    """

    world: str
    plant_width: float
    plant_circumradius: float
    routes: tuple[RouteCheck, ...]
    faults: tuple[str, ...]
    warnings: tuple[str, ...]
    notes: tuple[str, ...]


def check_world(world: World, plant_width: float, plant_circumradius: float) -> WorldCheck:
    """Measure every route and name every fault.

    plant_width : m across its way. plant_circumradius : m, of the circle swept by a turn.
    """
    walls, swept = obstacles(world.scene.bodies), sweeps(world)
    footprint = _footprint(world, plant_width, plant_circumradius)
    faults = [*_start_faults(world, walls, swept, footprint)]
    warnings = [*_length_warnings(world), *through_walls(swept, walls)]
    notes: list[str] = []
    if not world.routes:
        faults.append(str(NoRoute(world.name)))
    for route in world.routes:
        faults += _target_faults(route, world.scene.bodies)
        faults += _joint_faults(route, world)
        faults += _wall_faults(route, walls, plant_width)
        faults += closures(route, swept, plant_width)
        warnings += _room_warnings(route, walls, plant_circumradius)
        notes += crossings(route, swept, plant_width)
    return WorldCheck(
        world.name,
        plant_width,
        plant_circumradius,
        tuple(_measured(route, walls) for route in world.routes),
        tuple(faults),
        tuple(warnings),
        tuple(notes),
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Footprint:
    """The robot at the start: length and width in m, points (n, 2) all over it."""

    length: float
    width: float
    points: Points


def _footprint(world: World, width: float, circumradius: float) -> _Footprint:
    half_width = width / 2
    half_length = sqrt(max(circumradius**2 - half_width**2, 0.0))
    grid = np.meshgrid(steps(-half_length, half_length), steps(-half_width, half_width))
    inside = np.stack([axis.ravel() for axis in grid], axis=1)
    points = np.array([world.start.pose.to_world(x, y) for x, y in inside.tolist()])
    return _Footprint(2 * half_length, width, points)


def _start_faults(
    world: World, walls: Obstacles, swept: tuple[Sweep, ...], footprint: _Footprint
) -> Iterator[str]:
    start = _at(world.start.x, world.start.y)
    near = walls.near(footprint.points, 0.0)
    inside = np.flatnonzero((near.distances(footprint.points) <= 0.0).any(axis=0))
    for name in dict.fromkeys(near.names[index] for index in inside):
        yield (
            f"the robot starts in wall '{name}': start {start} "
            f"leaves no room for {footprint.length:.2f} x {footprint.width:.2f} m"
        )
    for sweep in swept:
        if in_reach(sweep, footprint.points, 0.0).any():
            yield f"the robot starts at {start}, where '{sweep.body.name}' comes past"


def _target_faults(route: Route, bodies: tuple[Body, ...]) -> Iterator[str]:
    targets = {body.name: body for body in bodies if body.role in ("target", "finish")}
    for leg in route.legs:
        body = targets.get(leg.target)
        if body is None:
            yield (
                f"route '{route.name}' leads to '{leg.target}', which is no target: the targets "
                f"are {', '.join(targets) or 'none'}{nearest(leg.target, targets)}"
            )
        elif dist(leg.path[-1], (body.x, body.y)) > REACH:
            yield (
                f"route '{route.name}' ends its leg to '{leg.target}' at {_at(*leg.path[-1])}, "
                f"{dist(leg.path[-1], (body.x, body.y)):.2f} m from it; {REACH} m is allowed"
            )
    last = targets.get(route.legs[-1].target)
    if last is not None and last.role != "finish":
        yield f"route '{route.name}' has no finish: its last leg must lead to a finish body"


def _joint_faults(route: Route, world: World) -> Iterator[str]:
    here, whence = (world.start.x, world.start.y), "the start"
    for leg in route.legs:
        if dist(here, leg.path[0]) > JOINT:
            yield (
                f"route '{route.name}' does not join: {whence} is at {_at(*here)}, the leg to "
                f"'{leg.target}' begins at {_at(*leg.path[0])}"
            )
        here, whence = leg.path[-1], f"the end of the leg to '{leg.target}'"


def _wall_faults(route: Route, walls: Obstacles, width: float) -> Iterator[str]:
    told: set[str] = set()
    for leg in route.legs:
        points = sampled(leg)
        near = walls.near(points, width / 2)
        distances = near.distances(points)
        touched = np.flatnonzero((distances < width / 2).any(axis=0))
        for name in dict.fromkeys(near.names[index] for index in touched):
            if name not in told:
                told.add(name)
                own = [index for index in touched if near.names[index] == name]
                yield _wall_fault(route, leg, name, distances[:, own].min(axis=1), points, width)


def _wall_fault(
    route: Route, leg: Leg, wall: str, distances: Points, points: Points, width: float
) -> str:
    closest = int(distances.argmin())
    where = f"route '{route.name}', leg to '{leg.target}', at {_at(*points[closest])}"
    if distances[closest] <= 0.0:
        return f"{where}: leads through wall '{wall}'"
    return (
        f"{where}: {distances[closest]:.2f} m from wall '{wall}', nearer than half the robot's "
        f"width of {width:.2f} m"
    )


def _room_warnings(route: Route, walls: Obstacles, circumradius: float) -> Iterator[str]:
    way = joined(route)
    for (x, y), turn in zip(way[1:-1], heading_changes(way), strict=True):
        gap = float(walls.distances(np.array([[x, y]])).min(initial=inf))
        if turn >= TURN and gap < circumradius:
            yield (
                f"route '{route.name}' turns at {_at(x, y)}, {gap:.2f} m from a wall: a turn "
                f"on the spot needs {circumradius:.2f} m"
            )


def _length_warnings(world: World) -> Iterator[str]:
    if not world.routes:
        return
    shortest = min(world.routes, key=lambda route: route.length)
    longest = max(world.routes, key=lambda route: route.length)
    if longest.length > shortest.length * (1 + EQUAL):
        yield (
            f"routes differ by more than {EQUAL:.0%}: '{shortest.name}' is {shortest.length:.2f} m "
            f"and '{longest.name}' {longest.length:.2f} m long"
        )


def _measured(route: Route, walls: Obstacles) -> RouteCheck:
    changes = heading_changes(joined(route))
    width, at = min((narrowest(leg, walls) for leg in route.legs), key=lambda found: found[0])
    return RouteCheck(
        name=route.name,
        length=route.length,
        turns=sum(TURN <= change < REVERSAL for change in changes),
        reversals=sum(change >= REVERSAL for change in changes),
        narrowest=None if width == inf else width,
        narrowest_at=None if width == inf else at,
    )


def _at(x: float, y: float) -> str:
    return f"({x:.2f}, {y:.2f})"
