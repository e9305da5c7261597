"""The world of 2017: the thesis's bill of materials, its primitives, its routes."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from math import dist, hypot

import pytest

from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Box
from omnistudy.worlds import World, load_world
from omnistudy.worlds.check import check_world

PRIMITIVES = ("primitive_a", "primitive_b", "primitive_c")


@pytest.fixture(scope="module")
def world() -> World:
    return load_world("utah2017")


def test_bill_of_materials(world: World) -> None:
    walls = [body for body in world.scene.bodies if body.role == "wall"]
    lengths = Counter(round(wall.geometry.x, 3) for wall in walls if isinstance(wall.geometry, Box))
    assert lengths == {1.0: 10, 0.5: 12, 2.0: 22}
    assert sum(length * number for length, number in lengths.items()) == pytest.approx(60.0)
    assert {wall.geometry.z for wall in walls if isinstance(wall.geometry, Box)} == {0.8}
    ends = {tuple(sorted(line.ends)) for line in world.walls.lines}
    assert len(ends) == 44, "no two walls stand in the same place"


def test_blocks_finish_and_door(world: World) -> None:
    roles = {body.name: body.role for body in world.bodies}
    assert {name for name, role in roles.items() if role == "target"} == {"red", "green", "blue"}
    assert list(roles.values()).count("finish") == 1
    (door,) = [body for body in world.bodies if body.role == "door"]
    assert door.hinge is not None
    assert door.mass > 0.0
    # Pushed at its far edge by the base's 200 N, the friction is overcome many times.
    assert isinstance(door.geometry, Box)
    assert 200.0 * door.geometry.x > 10.0 * door.hinge.friction


def test_three_routes_visit_the_blocks_in_their_orders_and_are_equally_long(world: World) -> None:
    orders = {route.name: [leg.target for leg in route.legs] for route in world.routes}
    assert orders == {
        "red-green-blue": ["red", "green", "blue", "finish"],
        "red-blue-green": ["red", "blue", "green", "finish"],
        "blue-green-red": ["blue", "green", "red", "finish"],
    }
    lengths = [
        sum(dist(a, b) for leg in route.legs for a, b in pairwise(leg.path))
        for route in world.routes
    ]
    assert max(lengths) - min(lengths) <= 0.02 * min(lengths)
    assert [route.length for route in world.routes] == pytest.approx(lengths)


def test_every_leg_begins_where_the_last_one_ended(world: World) -> None:
    for route in world.routes:
        assert route.legs[0].path[0] == (world.start.x, world.start.y)
        for leg, following in pairwise(route.legs):
            assert leg.path[-1] == following.path[0]


def test_routes_are_clear_for_the_robot_and_it_can_turn_at_every_block(world: World) -> None:
    robot = Youbot()
    found = check_world(world, robot.width, robot.circumradius)
    assert found.faults == ()
    assert found.warnings == ()
    for route in found.routes:
        assert route.narrowest is not None
        assert route.narrowest > 2 * robot.circumradius
    walls = [line.ends for line in world.walls.lines]
    for leg in world.routes[0].legs:
        end = leg.path[-1]
        assert min(_distance(end, *wall) for wall in walls) > robot.circumradius


def _distance(point: tuple[float, float], a: tuple[float, float], b: tuple[float, float]) -> float:
    """Distance of a point from a wall's centre line, m."""
    ux, uy = b[0] - a[0], b[1] - a[1]
    share = ((point[0] - a[0]) * ux + (point[1] - a[1]) * uy) / (ux * ux + uy * uy)
    share = max(0.0, min(1.0, share))
    return hypot(a[0] + share * ux - point[0], a[1] + share * uy - point[1])


def test_regions_are_the_primitives_of_the_blue_and_the_green_part(world: World) -> None:
    groups: dict[str, set[str]] = {"blue": set(), "green": set()}
    for region in world.regions:
        groups[region.group].add(region.name[0])
    assert groups == {"blue": {"a", "c"}, "green": {"a", "b"}}


def test_every_route_passes_every_region(world: World) -> None:
    for route in world.routes:
        points = [
            (a[0] + share / 50 * (b[0] - a[0]), a[1] + share / 50 * (b[1] - a[1]))
            for leg in route.legs
            for a, b in pairwise(leg.path)
            for share in range(51)
        ]
        for region in world.regions:
            assert any(region.contains(*point) for point in points), region.name


@pytest.mark.parametrize("name", PRIMITIVES)
def test_primitives_are_worlds_of_their_own(name: str) -> None:
    world = load_world(name)
    robot = Youbot()
    assert check_world(world, robot.width, robot.circumradius).faults == ()
    reversals = check_world(world, robot.width, robot.circumradius).routes[0].reversals
    assert reversals == (1 if name == "primitive_a" else 0)
