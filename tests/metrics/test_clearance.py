"""Gaps between a robot's outline and walls, worked out by hand."""

from __future__ import annotations

from math import inf, pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from omnistudy.metrics.clearance import clearance
from omnistudy.scene import Body, Box, Cylinder, Patrol

HALF = (0.3, 0.2)
WALL = Body(name="wall", role="wall", geometry=Box(x=2.0, y=0.1, z=0.8), x=0.0, y=1.0, z=0.4)


def gaps(bodies: list[Body], *poses: tuple[float, float, float]) -> NDArray[np.float64]:
    times = np.arange(len(poses), dtype=float)
    return clearance(times, np.array(poses), HALF, bodies)


def test_a_wall_beside_a_robot_is_as_far_as_between_their_faces() -> None:
    assert gaps([WALL], (0.0, 0.0, 0.0)) == pytest.approx([0.95 - 0.2])
    assert gaps([WALL], (0.0, 0.0, pi / 2)) == pytest.approx([0.95 - 0.3])


def test_a_turned_robot_is_as_far_as_its_corner() -> None:
    corner = 0.3 * sqrt(0.5) + 0.2 * sqrt(0.5)
    assert gaps([WALL], (0.0, 0.0, pi / 4)) == pytest.approx([0.95 - corner])


def test_the_end_of_a_wall_is_met_by_the_face_of_the_robot() -> None:
    post = Body(name="end", role="wall", geometry=Box(x=1.0, y=0.02, z=0.8), x=1.0, y=0.0, z=0.4)
    assert gaps([post], (0.0, 0.0, 0.0)) == pytest.approx([0.5 - 0.3])


def test_a_round_post_is_its_radius_nearer() -> None:
    post = Body(
        name="post", role="wall", geometry=Cylinder(radius=0.1, length=1.0), x=0.7, y=0.5, z=0.5
    )
    assert gaps([post], (0.0, 0.0, 0.0)) == pytest.approx([0.5 - 0.1])
    assert gaps([post], (0.7, 0.5, 1.0)) == pytest.approx([0.0])


def test_only_walls_count_and_the_nearest_does() -> None:
    block = Body(name="red", role="target", geometry=Box(x=0.2, y=0.2, z=0.1), x=0.5, y=0.0, z=0.05)
    assert gaps([block], (0.0, 0.0, 0.0)) == [inf]
    nearer = WALL.model_copy(update={"y": -0.5})
    assert gaps([WALL, nearer, block], (0.0, 0.0, 0.0)) == pytest.approx([0.45 - 0.2])


def test_a_moving_wall_is_where_it_is_at_that_time() -> None:
    cart = Body(
        name="cart",
        role="wall",
        geometry=Box(x=0.2, y=0.2, z=0.5),
        x=1.0,
        y=0.0,
        z=0.25,
        motion=Patrol(waypoints=((3.0, 0.0),), speed=1.0),
    )
    still = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert gaps([cart], *still) == pytest.approx([0.6, 1.6])
