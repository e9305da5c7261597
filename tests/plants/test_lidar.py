"""The lidar sees walls where plane geometry says they are, and does not see low blocks."""

from __future__ import annotations

from math import cos, pi, sin, tau

import numpy as np
import pytest
from core_world import block, door, scene, wall_ahead
from numpy.typing import NDArray

from omnistudy.geometry import PlanarPose
from omnistudy.geometry.ray_casting import Segment, cast
from omnistudy.plants.lidar import Lidar
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body, Box

FRONT, LEFT, REAR, RIGHT = 64, 96, 0, 32


def seen(bodies: tuple[Body, ...], pose: PlanarPose) -> NDArray[np.float64]:
    plant = Youbot().build(scene(*bodies), pose, 240, "seed")
    scan = plant.scan()
    plant.close()
    assert scan is not None
    return scan.ranges


def faces(body: Body) -> list[Segment]:
    """The four sides of a box as lines on the floor."""
    shape = body.geometry
    assert isinstance(shape, Box)
    frame = PlanarPose(body.x, body.y, body.yaw)
    hx, hy = shape.x / 2, shape.y / 2
    corners = [frame.to_world(x, y) for x, y in ((hx, hy), (-hx, hy), (-hx, -hy), (hx, -hy))]
    return list(zip(corners, corners[1:] + corners[:1], strict=True))


def test_angles_step_by_a_64th_of_pi_from_behind() -> None:
    angles = Lidar().angles
    assert len(angles) == 128
    assert angles[REAR] == -pi
    assert np.allclose(np.diff(angles), tau / 128)
    assert angles[FRONT] == 0.0
    assert angles[LEFT] == pytest.approx(pi / 2)


@pytest.mark.parametrize(
    ("heading", "ray"), [(0.0, FRONT), (pi / 2, RIGHT), (-pi / 2, LEFT), (pi, REAR)]
)
def test_a_wall_east_is_seen_by_the_ray_that_looks_east(heading: float, ray: int) -> None:
    ranges = seen((wall_ahead(0.5),), PlanarPose(0.05, 0.0, heading))
    assert ranges[ray] == pytest.approx(0.45, abs=1e-4)
    assert np.argmin(ranges) == ray


@pytest.mark.parametrize("number", range(8))
def test_ranges_agree_with_plane_geometry(number: int) -> None:
    rng = np.random.default_rng(number)
    posts = []
    for i in range(5):
        away, direction, turned = rng.uniform(0.45, 0.6), i * tau / 5, rng.uniform(0, pi)
        posts.append(
            Body(
                name=f"post {i}",
                role="wall",
                geometry=Box(x=0.15, y=0.1, z=0.8),
                x=away * cos(direction),
                y=away * sin(direction),
                z=0.4,
                yaw=turned,
            )
        )
    pose = PlanarPose(0.0, 0.0, float(rng.uniform(-pi, pi)))
    exact = cast([face for post in posts for face in faces(post)], pose, Lidar().angles, 0.6)
    ranges = seen(tuple(posts), pose)
    apart = np.abs(ranges - exact.ranges)
    # PyBullet's rays round by up to half a millimetre; one that grazes an edge may miss it
    assert np.sort(apart)[-3] < 1e-3
    assert np.median(apart[exact.ranges < 0.6]) < 1e-4
    assert (exact.ranges < 0.6).sum() > 10


def test_nothing_near_is_the_full_range() -> None:
    assert (seen((), PlanarPose(3.0, 1.0, 0.3)) == 0.6).all()


def test_low_blocks_are_not_seen_but_a_door_is() -> None:
    assert (seen((block("red", 0.5, 0.0),), PlanarPose(0, 0, 0)) == 0.6).all()
    assert seen((door(0.5),), PlanarPose(0, 0, 0))[FRONT] == pytest.approx(0.48, abs=1e-3)


def test_rays_and_range_are_parameters() -> None:
    youbot = Youbot(lidar=Lidar(rays=16, max_range=2.0))
    plant = youbot.build(scene(wall_ahead(1.5)), PlanarPose(0, 0, 0), 240, "seed")
    scan = plant.scan()
    plant.close()
    assert scan is not None
    assert scan.ranges.shape == (16,)
    assert scan.max_range == 2.0
    assert scan.ranges[8] == pytest.approx(1.5, abs=1e-3)
