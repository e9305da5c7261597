"""A map becomes a world in which a robot can drive, at the command line and in physics."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest
import yaml
from PIL import Image

from omnistudy.errors.worlds import NoFreeSpace, NoRoute, TooManyBoxes
from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body
from omnistudy.worlds import World, load_world
from omnistudy.worlds.check import check_world
from omnistudy.worlds.map_world import import_map
from omnistudy.worlds.page import write_world

# North at the top: a room of 3 m x 2 m in cells of 0.25 m, with a post in it.
ROOM = (
    "############",
    "#..........#",
    "#..........#",
    "#....#.....#",
    "#..........#",
    "#..........#",
    "#..........#",
    "############",
)
SHADES = {"#": 0, ".": 254, "?": 205}


def drawn(
    folder: Path,
    rows: tuple[str, ...] = ROOM,
    resolution: float = 0.25,
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> Path:
    pixels = np.array([[SHADES[letter] for letter in row] for row in rows], dtype=np.uint8)
    Image.fromarray(pixels).save(folder / "room.pgm")
    given = {
        "image": "room.pgm",
        "resolution": resolution,
        "origin": list(origin),
        "negate": 0,
        "occupied_thresh": 0.65,
        "free_thresh": 0.196,
    }
    file = folder / "room.yaml"
    file.write_text(yaml.safe_dump(given), encoding="utf-8")
    return file


def place(body: Body) -> tuple[float, float, float, float]:
    shape = body.geometry
    assert shape.shape == "box"
    return body.x, body.y, shape.x, shape.y


def test_a_room_is_four_walls_and_a_post(tmp_path: Path) -> None:
    imported = import_map(drawn(tmp_path))
    assert (imported.columns, imported.rows, imported.occupied) == (12, 8, 37)
    boxes = [place(body) for body in imported.world.scene.bodies]
    assert boxes == [
        (1.5, 0.125, 3.0, 0.25),  # south
        (0.125, 1.125, 0.25, 1.75),  # west, with the corner in the north
        (2.875, 1.125, 0.25, 1.75),  # east
        (1.375, 1.125, 0.25, 0.25),  # the post: column 5, the fifth row from below
        (1.5, 1.875, 2.5, 0.25),  # north
    ]
    assert {body.z for body in imported.world.scene.bodies} == {0.4}


def test_the_yaw_of_the_origin_turns_everything(tmp_path: Path) -> None:
    # A quarter to the left about (10, 20): 1.5 m along the image are 1.5 m north.
    world = import_map(drawn(tmp_path, origin=(10.0, 20.0, pi / 2))).world
    south = world.scene.bodies[0]
    assert (south.x, south.y, south.yaw) == pytest.approx((10.0 - 0.125, 20.0 + 1.5, pi / 2))
    post = world.scene.bodies[3]
    assert (post.x, post.y) == pytest.approx((10.0 - 1.125, 20.0 + 1.375))
    assert world.start.theta == pi / 2


def test_unknown_cells_stay_open_and_are_counted(tmp_path: Path) -> None:
    imported = import_map(drawn(tmp_path, ("####", "#?.#", "#..#", "####")))
    assert (imported.occupied, imported.unknown) == (12, 1)
    assert len(imported.world.scene.bodies) == 4


def test_the_robot_starts_at_the_widest_place_or_where_it_is_told(tmp_path: Path) -> None:
    file = drawn(tmp_path)
    # Between the post and the eastern wall: cells 6 to 10 in five columns, six rows high.
    start = import_map(file).world.start
    assert (start.x, start.y) == (2.125, 0.875)
    assert import_map(file, PlanarPose(0.5, 0.5, 1.0)).world.start.pose == (0.5, 0.5, 1.0)


def test_a_map_without_free_space_is_refused(tmp_path: Path) -> None:
    with pytest.raises(NoFreeSpace, match="no cell is free: 4 are occupied and 2 unknown"):
        import_map(drawn(tmp_path, ("###", "?#?")))


def test_an_image_of_specks_is_refused(tmp_path: Path) -> None:
    file = drawn(tmp_path)
    chequered = np.indices((300, 300)).sum(axis=0) % 2 * 254
    Image.fromarray(chequered.astype(np.uint8)).save(tmp_path / "room.pgm")
    with pytest.raises(TooManyBoxes, match="need more than 20000 boxes"):
        import_map(file)


def test_a_world_without_a_route_says_what_to_add(tmp_path: Path) -> None:
    world = import_map(drawn(tmp_path)).world
    (fault,) = check_world(world, 0.38, 0.35).faults
    assert "has no route: add one to its page under `routes`" in fault
    with pytest.raises(NoRoute, match="has no route"):
        world.route("reference")
    with pytest.raises(NoRoute, match="has no route"):
        _ = world.first_route


def test_a_goal_makes_a_route_that_is_checked(tmp_path: Path) -> None:
    file = drawn(tmp_path)
    start = PlanarPose(0.7, 0.6, 0.0)
    clear = import_map(file, start, (2.3, 0.6)).world
    assert check_world(clear, 0.38, 0.35).faults == ()
    blocked = import_map(file, start, (1.375, 1.125)).world
    (fault,) = check_world(blocked, 0.38, 0.35).faults
    assert "leads through wall 'map'" in fault


def test_a_written_page_is_read_as_the_same_world(tmp_path: Path) -> None:
    world = import_map(drawn(tmp_path, origin=(0.1, -0.2, 0.3)), None, (1.0, 0.5)).world
    write_world(world, tmp_path / "page.yaml")
    assert load_world(tmp_path / "page.yaml") == world


def test_every_box_stands_in_the_physics_and_is_touched_as_the_map(tmp_path: Path) -> None:
    # A chequered floor of 70 boxes, more than one PyBullet body holds, round a free corner.
    rows = tuple(
        "".join("#" if (r + c) % 2 == 0 and r < 14 else "." for c in range(10)) for r in range(20)
    )
    imported = import_map(drawn(tmp_path, rows, resolution=0.5), PlanarPose(2.5, 1.2, pi / 2))
    world = imported.world
    assert len(world.scene.bodies) == 70
    running = Youbot().build(world.scene, world.start.pose, 240, "seed")
    seen = _struck_from_above(running, world)
    assert seen == 70
    for _ in range(4 * 240):
        running.command(PlanarTwist(0.5, 0.0, 0.0))
        running.step()
    assert running.state.contacts.walls == ("map",)
    running.close()


def _struck_from_above(running: object, world: World) -> int:
    from omnistudy.plants.bullet import pybullet
    from omnistudy.plants.mecanum_physics import RunningMecanum

    assert isinstance(running, RunningMecanum)
    hits = pybullet.rayTestBatch(
        [(body.x, body.y, 3.0) for body in world.scene.bodies],
        [(body.x, body.y, 0.0) for body in world.scene.bodies],
        physicsClientId=running._client,
    )
    return sum(running._scene.walls.get(hit[0]) == "map" for hit in hits)
