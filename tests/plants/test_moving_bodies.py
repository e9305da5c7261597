"""Bodies on scripted paths in real physics: they push, are seen, and are never pushed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from core_world import wall

from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.plants.bullet import pybullet
from omnistudy.plants.mecanum_physics import RunningMecanum
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body, Box, Cylinder, Patrol, Scene

HZ = 240
ORIGIN = PlanarPose(0.0, 0.0, 0.0)
STILL = PlanarTwist(0.0, 0.0, 0.0)
FULL = PlanarTwist(0.36, 0.0, 0.0)


def cart(x: float, y: float, to: tuple[float, float], speed: float = 0.3) -> Body:
    return Body(
        name="cart",
        role="wall",
        geometry=Cylinder(radius=0.25, length=1.0),
        x=x,
        y=y,
        z=0.5,
        motion=Patrol(waypoints=(to,), speed=speed),
    )


class Seen(NamedTuple):
    """What came of a drive: poses of robot and cart, the deepest overlap in m, walls touched."""

    robot: list[PlanarPose]
    cart: list[tuple[float, float]]
    deepest: float
    touched: set[str]


def driven(scene: Scene, command: PlanarTwist, seconds: float, start: PlanarPose = ORIGIN) -> Seen:
    running = Youbot().build(scene, start, HZ, "seed")
    assert isinstance(running, RunningMecanum)
    uid = next(uid for uid, name in running._scene.walls.items() if name == "cart")
    client = running._client
    seen = Seen([], [], 0.0, set())
    for _ in range(round(seconds * HZ)):
        running.command(command)
        running.step()
        points = pybullet.getClosestPoints(running._robot, uid, 0.01, physicsClientId=client)
        deepest = min((seen.deepest, *(point[8] for point in points)))
        x, y, _ = pybullet.getBasePositionAndOrientation(uid, physicsClientId=client)[0]
        seen.robot.append(running.state.pose)
        seen.cart.append((x, y))
        seen = seen._replace(
            deepest=deepest, touched=seen.touched | set(running.state.contacts.walls)
        )
    running.close()
    return seen


def test_a_body_is_where_its_path_says_after_every_step() -> None:
    body = cart(3.0, 1.0, (3.0, -1.0))
    track = body.track
    assert track is not None
    seen = driven(Scene(bodies=(body,)), STILL, 8.0)  # 2 m at 0.3 m/s: it has turned by then
    assert seen.cart == [
        pytest.approx(track.at((step + 1) / HZ)[:2], abs=1e-9) for step in range(8 * HZ)
    ]


def test_a_body_takes_the_robot_along_at_its_own_speed_without_sinking_in() -> None:
    seen = driven(Scene(bodies=(cart(0.05, 1.0, (0.05, -1.0)),)), STILL, 6.0)
    assert seen.touched == {"cart"}
    # It touches the chassis, whose side lies 2 mm behind the wheels', at y = 0.25 + 0.188, and
    # goes on to y = -0.8: the robot goes the same 1.238 m.
    assert seen.robot[-1].y == pytest.approx(-1.238, abs=0.0005)
    assert seen.deepest > -0.0001


def test_the_robot_cannot_push_a_body_at_full_drive() -> None:
    slow = cart(1.0, 0.0, (1.0, 0.01), speed=0.001)
    seen = driven(Scene(bodies=(slow,)), FULL, 6.0)
    assert seen.touched == {"cart"}
    assert {x for x, _ in seen.cart} == {1.0}
    assert seen.robot[-1].x == pytest.approx(1.0 - 0.25 - 0.29, abs=0.001)
    assert seen.deepest > -0.0001


def test_a_body_passes_through_a_robot_that_it_has_caught_against_a_wall() -> None:
    crate = cart(0.0, 1.0, (0.0, -1.0)).model_copy(update={"geometry": Box(x=0.5, y=0.5, z=1.0)})
    seen = driven(Scene(bodies=(crate, wall("w", (-3, -0.3), (3, -0.3)))), STILL, 8.0)
    assert seen.touched == {"cart", "w"}
    # Half a wall and half the robot off the wall's middle, and nowhere near what a solver that
    # cannot win makes of it (9 m/s).
    assert seen.robot[-1][:2] == pytest.approx((0.0, -0.3 + 0.05 + 0.19), abs=0.0005)
    fastest = float(np.abs(np.diff(np.array(seen.robot), axis=0)[:, :2]).max()) * HZ
    assert fastest == pytest.approx(0.3, abs=0.001)


def test_a_robot_is_not_pressed_into_the_wall_behind_it() -> None:
    # Askew and off its middle, the robot takes the push on one corner and the wall on another.
    crate = cart(0.1, 1.0, (0.1, -1.0)).model_copy(update={"geometry": Box(x=0.5, y=0.7, z=1.0)})
    scene = Scene(bodies=(crate, wall("w", (-3, -0.5), (3, -0.5))))
    for theta in (0.2, 1.0, -0.4):
        seen = driven(scene, STILL, 8.0, PlanarPose(0.0, 0.0, theta))
        corners = [
            pose.to_world(x, y)[1]
            for pose in seen.robot
            for x in (-0.29, 0.29)
            for y in (-0.19, 0.19)
        ]
        assert min(corners) > -0.45 - 0.006, theta


def test_a_body_that_passed_through_pushes_again_once_it_is_apart() -> None:
    crate = cart(0.0, 1.0, (0.0, -1.0)).model_copy(update={"geometry": Box(x=0.5, y=0.5, z=1.0)})
    seen = driven(Scene(bodies=(crate, wall("w", (-3, -0.3), (3, -0.3)))), STILL, 10.0)
    # Coming back, it takes the robot along from the other side: y = -0.4 after 10 s.
    assert seen.cart[-1][1] == pytest.approx(0.0, abs=0.001)
    assert seen.robot[-1].y == pytest.approx(0.25 + 0.19, abs=0.003)


def test_the_lidar_sees_a_body_come_and_go() -> None:
    running = Youbot().build(
        Scene(bodies=(cart(0.7, 1.5, (0.7, -1.5), speed=0.5),)), ORIGIN, HZ, "seed"
    )
    ahead = 64  # the ray straight ahead of 128
    ranges = []
    for _ in range(6 * HZ):
        running.step()
        scan = running.scan()
        assert scan is not None
        ranges.append(float(scan.ranges[ahead]))
    running.close()
    assert ranges[0] == scan.max_range
    # It is straight ahead after 1.5 m at 0.5 m/s, its face 0.45 m off.
    assert ranges[3 * HZ - 1] == pytest.approx(0.45, abs=0.002)
    assert ranges[-1] == scan.max_range


def test_the_same_drive_gives_the_same_bytes() -> None:
    scene = Scene(bodies=(cart(0.6, 1.0, (0.6, -1.0)), wall("w", (-3, -0.6), (3, -0.6))))
    assert driven(scene, FULL, 6.0) == driven(scene, FULL, 6.0)
