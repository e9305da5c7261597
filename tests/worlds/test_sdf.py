"""Gazebo worlds are read with every pose composed; what cannot be read is said."""

from __future__ import annotations

import re
from math import inf, nan, pi
from pathlib import Path

import numpy as np
import pytest

from omnistudy.errors.worlds import BrokenPath, BrokenSdf, NoWay
from omnistudy.geometry import PlanarPose
from omnistudy.scene import Box, Cylinder
from omnistudy.session.barn import barn_worlds
from omnistudy.worlds.path_file import read_path
from omnistudy.worlds.sdf import import_sdf

START = PlanarPose(0.0, 0.0, 0.0)
GOAL = (4.0, 0.0)


def sdf(folder: Path, *models: str, extra: str = "") -> Path:
    file = folder / "small.world"
    body = "".join(models) + extra
    file.write_text(f"<sdf version='1.6'><world name='w'>{body}</world></sdf>", encoding="utf-8")
    return file


def model(name: str, pose: str, link_pose: str, collision_pose: str, shape: str) -> str:
    return (
        f"<model name='{name}'><pose>{pose}</pose><link name='l'><pose>{link_pose}</pose>"
        f"<collision name='c'><pose>{collision_pose}</pose><geometry>{shape}</geometry>"
        "</collision></link></model>"
    )


BOX = "<box><size>2 0.5 1</size></box>"
POST = "<cylinder><radius>0.1</radius><length>2</length></cylinder>"
STAY = "0 0 0 0 0 0"


def test_poses_of_model_link_and_collision_are_composed(tmp_path: Path) -> None:
    # The model stands at (1, 2), turned a quarter to the left; its link 3 m ahead of it is 3 m
    # further along y; the collision's 1 m to the link's left is 1 m towards -x.
    turned = model("turned", "1 2 0.5 0 0 1.5707963", "3 0 0 0 0 0.25", "0 1 0.25 0 0 0", BOX)
    (body, _) = import_sdf(sdf(tmp_path, turned), START, GOAL).world.bodies
    quarter = 1.5707963
    assert body.x == pytest.approx(1.0 - np.sin(0.25 + pi / 2), abs=1e-6)
    assert body.y == pytest.approx(2.0 + 3.0 + np.cos(0.25 + pi / 2), abs=1e-6)
    assert body.z == pytest.approx(0.75)
    assert body.yaw == pytest.approx(quarter + 0.25)
    assert body.geometry == Box(x=2.0, y=0.5, z=1.0)
    assert (body.role, body.solid) == ("wall", True)


def test_poses_in_degrees_are_turned(tmp_path: Path) -> None:
    turned = model("m", "1 2 0.5 0 0 90", "1 0 0 0 0 0", STAY, BOX)
    file = sdf(tmp_path, turned.replace("<pose>1 2", "<pose degrees='true'>1 2"))
    (body, _) = import_sdf(file, START, GOAL).world.bodies
    assert (body.x, body.y, body.yaw) == pytest.approx((1.0, 3.0, pi / 2))


def test_models_in_models_stand_where_the_outer_one_puts_them(tmp_path: Path) -> None:
    # The outer model is turned a quarter to the left: 2 m ahead of it is 2 m further along y.
    inner = model("leg", "2 0 0 0 0 0", STAY, STAY, POST)
    include = "<include><uri>model://lamp</uri></include>"
    pose = "<pose>1 1 0 0 0 1.5707963267948966</pose>"
    file = sdf(tmp_path, f"<model name='table'>{pose}{inner}{include}</model>")
    imported = import_sdf(file, START, GOAL)
    (body, _) = imported.world.bodies
    assert (body.name, body.x, body.y) == ("table::leg", pytest.approx(1.0), pytest.approx(3.0))
    assert imported.left_out == ("included model model://lamp",)


def test_only_a_plane_that_faces_up_is_the_floor(tmp_path: Path) -> None:
    plane = "<plane><normal>{}</normal></plane>"
    floor = model("floor", STAY, STAY, STAY, plane.format("0 0 1"))
    wall = model("side", STAY, STAY, STAY, plane.format("1 0 0"))
    imported = import_sdf(sdf(tmp_path, floor, wall), START, GOAL)
    assert imported.left_out == ("the plane of model 'side'",)


@pytest.mark.parametrize(
    ("start", "goal"),
    [(START, (0.0, 0.0)), (PlanarPose(0, 0, nan), GOAL), (START, (inf, 0.0))],
)
def test_no_way_to_drive_is_one_sentence(
    tmp_path: Path, start: PlanarPose, goal: tuple[float, float]
) -> None:
    with pytest.raises(NoWay, match="give two different places"):
        import_sdf(sdf(tmp_path), start, goal)


def test_cylinders_boxes_and_the_floor(tmp_path: Path) -> None:
    plane = model("floor", STAY, STAY, STAY, "<plane><normal>0 0 1</normal></plane>")
    post = model("post", "1 -1 1 0 0 0", STAY, STAY, POST)
    *walls, goal = import_sdf(sdf(tmp_path, plane, post), START, GOAL).world.bodies
    assert [(wall.name, wall.x, wall.y, wall.z) for wall in walls] == [("post", 1.0, -1.0, 1.0)]
    assert walls[0].geometry == Cylinder(radius=0.1, length=2.0)
    assert (goal.role, goal.x, goal.y, goal.solid) == ("finish", 4.0, 0.0, False)


def test_saved_state_is_left_alone_and_what_cannot_be_read_is_named(tmp_path: Path) -> None:
    state = f"<state world_name='w'>{model('post', '9 9 9 0 0 0', STAY, STAY, POST)}</state>"
    mesh = model("chair", STAY, STAY, STAY, "<mesh><uri>chair.dae</uri></mesh>")
    include = "<include><uri>model://table</uri></include>"
    imported = import_sdf(sdf(tmp_path, mesh, extra=include + state), START, GOAL)
    assert len(imported.world.bodies) == 1
    assert imported.left_out == ("included model model://table", "the mesh of model 'chair'")


def test_route_goes_from_start_along_the_path_to_the_goal(tmp_path: Path) -> None:
    world = import_sdf(sdf(tmp_path), START, GOAL, [(1.0, 1.0), (3.0, 1.0), (4.0, 0.0)]).world
    assert world.routes[0].legs[0].path == ((0.0, 0.0), (1.0, 1.0), (3.0, 1.0), (4.0, 0.0))


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("<sdf", "cannot be read as XML"),
        ("<?xml version='1.0' encoding='none-such'?><sdf/>", "cannot be read as XML"),
        ("<robot name='r'/>", "holds no <sdf> with a <world>"),
        (model("m", "1 2", STAY, STAY, BOX), "pose of model 'm' is '1 2', where 6 numbers"),
        (model("m", "a b c d e f", STAY, STAY, BOX), "pose of model 'm' is 'a b c d e f', not"),
        (model("m", "nan 0 0 0 0 0", STAY, STAY, BOX), "'nan 0 0 0 0 0', not finite numbers"),
        (
            model("m", STAY, STAY, STAY, BOX).replace("<pose>", "<pose relative_to='a'>", 1),
            "model 'm' has a pose relative to 'a'",
        ),
        (model("m", "0 0 0 0.5 0 0", STAY, STAY, BOX), "model 'm' is tilted"),
        (model("m", STAY, STAY, STAY, "<box/>"), "box of model 'm' is '', where 3 numbers"),
        (model("m", STAY, STAY, STAY, POST.replace("0.1", "0")), "cylinder of model 'm' has no"),
    ],
)
def test_a_file_that_is_no_such_world_is_one_sentence(
    tmp_path: Path, content: str, said: str
) -> None:
    file = tmp_path / "bad.world"
    whole = content.startswith("<model")
    file.write_text(f"<sdf><world>{content}</world></sdf>" if whole else content, encoding="utf-8")
    with pytest.raises(BrokenSdf, match=re.escape(said)):
        import_sdf(file, START, GOAL)


def test_a_file_that_is_not_there_is_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(BrokenSdf, match="there is no such file"):
        import_sdf(tmp_path / "none.sdf", START, GOAL)


def test_two_models_of_one_name_are_told(tmp_path: Path) -> None:
    post = model("post", STAY, STAY, STAY, POST)
    with pytest.raises(BrokenSdf, match="'post'"):
        import_sdf(sdf(tmp_path, post, post), START, GOAL)


def test_path_rows_are_cells_of_a_grid(tmp_path: Path) -> None:
    np.save(tmp_path / "path.npy", np.array([[0, 0], [2, 10]]))
    (tmp_path / "path.csv").write_text("0,0\n2,10\n", encoding="utf-8")
    for name in ("path.npy", "path.csv"):
        cells = read_path(tmp_path / name, 0.15, (-4.575, 5.075))
        assert np.array(cells) == pytest.approx(np.array([[-4.575, 5.075], [-4.275, 6.575]]))


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (np.zeros((2, 3)), "shape is"),
        (np.array([[0.0, nan]]), "no finite number"),
        (np.array([["a", "b"]]), "no finite number"),
        (b"text", "cannot be read as numbers"),
    ],
)
def test_path_that_is_none_is_one_sentence(tmp_path: Path, content: object, said: str) -> None:
    file = tmp_path / "path.npy"
    if isinstance(content, bytes):
        file.write_bytes(content)
    else:
        np.save(file, content)
    with pytest.raises(BrokenPath, match=said):
        read_path(file)


def test_real_barn_worlds_hold_every_cylinder(shared_data: Path) -> None:
    worlds = {world.name: world for world in barn_worlds(shared_data / "barn")}
    assert len(worlds) == 5
    for name, world in worlds.items():
        number = name.removeprefix("barn_")
        text = (shared_data / "barn" / f"world_{number}.world").read_text(encoding="utf-8")
        before_state = text.partition("<state")[0]
        collisions = re.findall(r"<collision.*?</collision>", before_state, re.S)
        cylinders = sum("<cylinder>" in collision for collision in collisions)
        assert len(world.bodies) == cylinders + 1
        assert world.routes[0].legs[0].path[-1] == (-2.25, 13.0)


@pytest.mark.parametrize("text", ["", "\n\n", "1,2\n3\n", "1,2,3\n", "a,b\n"])
def test_csv_path_that_is_none_is_one_sentence(tmp_path: Path, text: str) -> None:
    file = tmp_path / "path.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(BrokenPath):
        read_path(file)


def actor(*waypoints: str, script: str = "") -> str:
    inside = "".join(
        f"<waypoint><time>{t}</time><pose>{place} 0 0 0 0</pose></waypoint>"
        for t, place in (one.split(":") for one in waypoints)
    )
    trajectory = f"<trajectory id='0' type='walk'>{inside}</trajectory>"
    return f"<actor name='ann'><script>{script}{trajectory}</script></actor>"


def test_an_actor_becomes_a_cylinder_that_keeps_its_times(tmp_path: Path) -> None:
    # Out in 4 s, a rest of 2 s, back in 4 s; the loop waits for its delay of 1 s again.
    way = ("4:2 1", "0:0 1", "6:2 1", "10:0 1")
    file = sdf(tmp_path, extra=actor(*way, script="<delay_start>1</delay_start>"))
    imported = import_sdf(file, START, GOAL)
    (ann, _) = imported.world.bodies
    assert (ann.name, ann.x, ann.y, ann.geometry) == (
        "ann",
        0.0,
        1.0,
        Cylinder(radius=0.25, length=1.7),
    )
    assert ann.track is not None
    assert ann.track.period == 11.0
    seen = [ann.track.at(t)[:2] for t in (0.5, 3.0, 5.0, 6.5, 9.0, 11.5, 14.0)]
    assert seen == [(0, 1), (1, 1), (2, 1), (2, 1), (1, 1), (0, 1), (1, 1)]
    assert imported.left_out == ()


def test_an_actor_without_a_loop_stays_where_it_arrives(tmp_path: Path) -> None:
    file = sdf(tmp_path, extra=actor("0:0 1", "4:2 1", script="<loop>false</loop>"))
    (ann, _) = import_sdf(file, START, GOAL).world.bodies
    assert ann.track is not None
    assert ann.track.at(100.0) == (2.0, 1.0, 0.0, 0.0)


def test_an_actor_who_stays_is_a_post(tmp_path: Path) -> None:
    (ann, _) = import_sdf(sdf(tmp_path, extra=actor("0:0 1", "4:0 1")), START, GOAL).world.bodies
    assert ann.motion is None


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (actor("0:0 1", "4:2 1"), "who would leap from the end of the way to its start"),
        (actor(), "whose trajectory has no waypoints"),
        ("<actor name='ann'><script/></actor>", "has no single trajectory that starts by itself"),
        (actor("0:0 1", "4:0 1", script="<auto_start>false</auto_start>"), "starts by itself"),
    ],
)
def test_an_actor_who_cannot_be_followed_is_named(tmp_path: Path, given: str, said: str) -> None:
    (line,) = import_sdf(sdf(tmp_path, extra=given), START, GOAL).left_out
    assert "'ann'" in line
    assert said in line


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (actor("soon:0 1"), "the time of a waypoint of actor 'ann' is 'soon', not numbers"),
        (actor("-1:0 1"), "is -1, before the script begins"),
        (actor("0:0"), "where 6 numbers are needed"),
    ],
)
def test_a_broken_waypoint_is_told(tmp_path: Path, given: str, said: str) -> None:
    with pytest.raises(BrokenSdf, match=re.escape(said)):
        import_sdf(sdf(tmp_path, extra=given), START, GOAL)


def test_two_stops_at_one_time_are_refused(tmp_path: Path) -> None:
    file = sdf(tmp_path, extra=actor("0:0 1", "4:1 1", "4:2 1", "8:0 1"))
    with pytest.raises(BrokenSdf, match="two waypoints of actor 'ann' have the time 4"):
        import_sdf(file, START, GOAL)
