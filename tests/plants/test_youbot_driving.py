"""The base in PyBullet: it drives as told, and things in its way stop it, give way or are seen."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from math import cos, hypot, pi, sin

import pytest
from core_world import block, door, scene, wall, wall_ahead, wall_left

from omnistudy.errors.plants import StartsInWall
from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.plants import RunningPlant
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body, Contacts

HZ = 240
ORIGIN = PlanarPose(0.0, 0.0, 0.0)


@contextmanager
def youbot(*bodies: Body, start: PlanarPose = ORIGIN) -> Iterator[RunningPlant]:
    plant = Youbot().build(scene(*bodies), start, HZ, "seed")
    try:
        yield plant
    finally:
        plant.close()


def drive(plant: RunningPlant, twist: PlanarTwist, seconds: float) -> list[Contacts]:
    """Drive on and tell what was touched after each step."""
    seen = []
    for _ in range(round(seconds * HZ)):
        plant.command(twist)
        plant.step()
        seen.append(plant.state.contacts)
    return seen


def moving(plant: RunningPlant, twist: PlanarTwist) -> PlanarPose:
    """Let the base reach its speed (0.2 s) and tell where it then is."""
    drive(plant, twist, 0.2)
    return plant.state.pose


@pytest.mark.parametrize(
    "twist", [PlanarTwist(0.36, 0, 0), PlanarTwist(0, -0.3, 0), PlanarTwist(0.2, 0.1, 0)]
)
def test_straight_and_sideways(twist: PlanarTwist) -> None:
    heading = 0.7
    with youbot(start=PlanarPose(1.0, -2.0, heading)) as plant:
        begin = moving(plant, twist)
        drive(plant, twist, 2.0)
        end = plant.state.pose
        assert begin.to_local(end.x, end.y) == pytest.approx((2 * twist.vx, 2 * twist.vy), abs=1e-5)
        assert end.theta == pytest.approx(heading)
        assert plant.state.twist == pytest.approx(twist, abs=1e-6)


def test_turning_on_the_spot() -> None:
    with youbot() as plant:
        begin = moving(plant, PlanarTwist(0, 0, -1.2))
        drive(plant, PlanarTwist(0, 0, -1.2), 6.0)
        end = plant.state.pose
        assert end.theta - begin.theta == pytest.approx(-7.2, abs=1e-4)
        assert (end.x, end.y) == pytest.approx((0.0, 0.0), abs=1e-6)


def test_an_arc() -> None:
    # 0.3 m/s and 0.6 rad/s: a circle of 0.5 m about the point 0.5 m to the left
    twist = PlanarTwist(0.3, 0, 0.6)
    with youbot() as plant:
        begin = moving(plant, twist)
        drive(plant, twist, 3.0)
        end = plant.state.pose
        turned = 0.6 * 3.0
        assert end.theta - begin.theta == pytest.approx(turned, abs=1e-3)
        wanted = (0.5 * sin(turned), 0.5 * (1 - cos(turned)))
        assert begin.to_local(end.x, end.y) == pytest.approx(wanted, abs=2e-3)


def test_way_is_summed_over_steps_there_and_back() -> None:
    with youbot() as plant:
        drive(plant, PlanarTwist(0.3, 0, 0), 1.0)
        drive(plant, PlanarTwist(-0.3, 0, 0), 1.0)
        assert plant.travelled == pytest.approx(0.6, abs=0.03)
        assert hypot(plant.state.pose.x, plant.state.pose.y) < 0.03


def test_channels_name_the_values() -> None:
    with youbot() as plant:
        drive(plant, PlanarTwist(0.3, 0, 0), 0.5)
        values = dict(zip([c.name for c in plant.channels], plant.values(), strict=True))
    assert values["wheel_rear_left"] == pytest.approx(6.0)
    assert values["vx"] == pytest.approx(0.3, abs=1e-6)
    assert 0.1 < values["x"] < 0.15


def test_a_wall_ahead_stops_the_base() -> None:
    with youbot(wall_ahead(0.5)) as plant:
        contacts = drive(plant, PlanarTwist(0.36, 0, 0), 3.0)
        assert contacts[0] == Contacts()
        last = contacts[-1]
        assert (last.walls, last.base, last.wheels, last.clear) == (("ahead",), True, False, False)
        assert last.bearing == pytest.approx(0.0, abs=1e-6)
        assert plant.state.pose.x + 0.29 == pytest.approx(0.5, abs=1e-4)
        assert abs(plant.state.twist.vx) < 1e-3


def test_a_wall_is_never_deep_in_the_base() -> None:
    with youbot(wall_ahead(0.5)) as plant:
        deepest = 0.0
        for _ in range(3 * HZ):
            drive(plant, PlanarTwist(0.36, 0.1, 0.3), 1 / HZ)
            pose = plant.state.pose
            corners = [pose.to_world(0.29, side) for side in (0.19, -0.19)]
            deepest = max(deepest, *(x - 0.5 for x, _ in corners))
    assert deepest < 0.0025


def test_rubbing_sideways_is_a_matter_of_the_wheels() -> None:
    with youbot(wall_left(0.3)) as plant:
        last = drive(plant, PlanarTwist(0.1, 0.3, 0), 2.0)[-1]
        assert (last.walls, last.base, last.wheels) == (("left",), False, True)
        assert last.bearing == pytest.approx(pi / 2, abs=1e-4)
        assert plant.state.twist.vx == pytest.approx(0.1, abs=1e-3)  # a wall has no grip


@pytest.mark.parametrize("heading", [0.0, 0.5, pi / 2, 2.5, -3.0])
def test_bearing_points_squarely_at_the_wall(heading: float) -> None:
    start = PlanarPose(0.0, 0.0, heading)
    ahead_in_the_world = PlanarTwist(0.3 * cos(heading), -0.3 * sin(heading), 0)
    with youbot(wall_ahead(0.5), start=start) as plant:
        for contact in drive(plant, ahead_in_the_world, 1.5):
            if contact.walls:
                towards = plant.state.pose.theta + contact.bearing
                assert (cos(towards), sin(towards)) == pytest.approx((1.0, 0.0), abs=0.02)
                break
        else:
            pytest.fail("the wall was never touched")


def test_a_wall_is_left_once_it_is_5_mm_off() -> None:
    with youbot(wall_ahead(0.5)) as plant:
        drive(plant, PlanarTwist(0.36, 0, 0), 1.5)
        gaps = []
        for _ in range(HZ):
            contact = drive(plant, PlanarTwist(-0.02, 0, 0), 1 / HZ)[0]
            gaps.append((0.5 - 0.29 - plant.state.pose.x, contact))
    touching = [gap for gap, contact in gaps if contact.walls]
    near = [gap for gap, contact in gaps if not contact.walls and not contact.clear]
    left = [gap for gap, contact in gaps if contact.clear]
    assert max(touching) < 2e-4 < max(near)
    assert max(near) == pytest.approx(0.005, abs=2e-4)
    assert min(left) == pytest.approx(0.005, abs=2e-4)


def test_clear_waits_for_every_wall_that_was_touched() -> None:
    # into the corner, then away from the wall ahead while still along the wall on the left
    with youbot(wall_ahead(0.5), wall_left(0.3)) as plant:
        walls = drive(plant, PlanarTwist(0.3, 0.3, 0), 2.0)[-1].walls
        assert sorted(walls) == ["ahead", "left"]
        along = drive(plant, PlanarTwist(-0.2, 0.1, 0), 1.0)[-1]
        assert (along.walls, along.clear) == (("left",), False)
        assert drive(plant, PlanarTwist(0, -0.2, 0), 1.0)[-1] == Contacts()


def test_a_block_is_noticed_but_stops_nothing() -> None:
    with youbot(block("red", 0.6, 0.0)) as plant:
        contacts = drive(plant, PlanarTwist(0.36, 0, 0), 4.0)
        first = next(i for i, contact in enumerate(contacts) if contact.others)
        assert contacts[first].others == ("red",)
        assert contacts[first].walls == ()
        assert first / HZ * 0.36 == pytest.approx(0.6 - 0.075 - 0.29, abs=0.02)
        assert contacts[-1].others == ()  # it has driven right through
        assert plant.state.pose.x == pytest.approx(4 * 0.36, abs=0.01)


def test_a_door_gives_way_and_is_no_wall() -> None:
    with youbot(door(0.6)) as plant:
        contacts = drive(plant, PlanarTwist(0.36, 0, 0), 5.0)
        assert any(contact.others == ("door",) for contact in contacts)
        assert all(contact.walls == () and contact.clear for contact in contacts)
        assert plant.state.pose.x > 1.2  # well past where the door stood


def test_a_door_does_not_open_by_itself() -> None:
    with youbot(door(0.6)) as plant:
        drive(plant, PlanarTwist(0, 0, 0), 2.0)
        front = 64
        assert plant.scan().ranges[front] == pytest.approx(0.58, abs=1e-3)  # type: ignore[union-attr]


def test_a_start_inside_a_wall_is_refused_by_name() -> None:
    with pytest.raises(StartsInWall, match=r"x = 0\.3 m, y = 0 m inside ahead: move"):
        Youbot().build(scene(wall_ahead(0.5)), PlanarPose(0.3, 0.0, 0.0), HZ, "seed")


def test_a_start_inside_a_wall_leaves_no_physics_behind() -> None:
    for _ in range(2):
        with pytest.raises(StartsInWall):
            Youbot().build(scene(wall_ahead(0.5)), PlanarPose(0.3, 0.0, 0.0), HZ, "seed")
    with youbot(wall_ahead(0.5)) as plant:
        assert drive(plant, PlanarTwist(0.36, 0, 0), 1.0)[-1].walls == ("ahead",)


def journey(plant: RunningPlant, step: int) -> bytes:
    """Command one step of a winding way that rubs along walls; give the pose's bytes."""
    plant.command(PlanarTwist(0.3, 0.3 * sin(step / 100), 0.5 * cos(step / 70)))
    plant.step()
    scan = plant.scan() if step % 5 == 0 else None
    return repr((plant.state, scan.ranges.tobytes() if scan else b"")).encode()


CORNER = (wall_ahead(0.9), wall_left(0.4), wall("right", (-2, -0.5), (2, -0.5)))


def winding(steps: int = 900) -> str:
    """Digest of everything seen on the winding way."""
    digest = hashlib.sha256()
    with youbot(*CORNER) as plant:
        for step in range(steps):
            digest.update(journey(plant, step))
    return digest.hexdigest()


def test_same_commands_same_bytes_here_and_in_another_process() -> None:
    here = winding()
    assert winding() == here
    script = "import test_youbot_driving as t; print(t.winding())"
    paths = f"import sys; sys.path[:0] = {[*sys.path, __file__.rpartition('/')[0]]!r}; "
    there = subprocess.run(
        [sys.executable, "-c", paths + script], capture_output=True, text=True, check=True
    )
    assert there.stdout.split()[-1] == here


def test_two_plants_in_one_process_do_not_disturb_each_other() -> None:
    alone = winding(400)
    digest = hashlib.sha256()
    with youbot(*CORNER) as plant, youbot(wall_ahead(0.5)) as other:
        for step in range(400):
            digest.update(journey(plant, step))
            drive(other, PlanarTwist(0.36, 0.1, -0.4), 1 / HZ)
    assert digest.hexdigest() == alone
