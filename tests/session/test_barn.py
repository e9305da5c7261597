"""BARN worlds: a small one made here, and one of the real ones."""

from __future__ import annotations

from math import hypot
from pathlib import Path

import numpy as np
import pytest

from omnistudy.cli import app as cli
from omnistudy.errors.drive import NotABarnFolder
from omnistudy.errors.worlds import BrokenPath
from omnistudy.scene import Cylinder
from omnistudy.session.barn import barn_world, barn_worlds
from omnistudy.session.drive import drive_worlds

MODEL = """
    <model name='{name}'><static>1</static><pose frame=''>{x} {y} 0 0 0 0</pose>
      <link name='link'><collision name='c'><geometry>{shape}</geometry></collision></link>
    </model>"""
POST = "<cylinder><radius>0.075</radius><length>1</length></cylinder>"
PLANE = "<plane><normal>0 0 1</normal></plane>"


def write_world(folder: Path, number: int, *models: str) -> Path:
    """Write a world with a ground plane and models, and a path of three cells."""
    ground = MODEL.format(name="ground_plane", x=0, y=0, shape=PLANE)
    file = folder / f"world_{number}.world"
    text = f"<sdf version='1.6'><world name='default'>{ground}{''.join(models)}</world></sdf>"
    file.write_text(text, encoding="utf-8")
    np.save(folder / f"path_{number}.npy", np.array([[16, 0], [15, 1], [15, 20]]))
    return file


def test_world_is_posts_start_goal_and_path(tmp_path: Path) -> None:
    posts = [
        MODEL.format(name=f"post_{i}", x=x, y=y, shape=POST)
        for i, (x, y) in enumerate([(-0.075, 0.075), (-4.425, 9.525)])
    ]
    world = barn_world(write_world(tmp_path, 7, *posts))
    *walls, goal = world.bodies
    assert world.name == "barn_7"
    assert [(body.name, body.x, body.y, body.role) for body in walls] == [
        ("post_0", -0.075, 0.075, "wall"),
        ("post_1", -4.425, 9.525, "wall"),
    ]
    assert {body.geometry for body in walls} == {Cylinder(radius=0.075, length=1.0)}
    assert (goal.x, goal.y, goal.role, goal.solid) == (-2.25, 13.0, "finish", False)
    assert world.start.pose == (-2.25, 3.0, 1.57)
    (leg,) = world.routes[0].legs
    expected = [(-2.25, 3.0), (-2.175, 5.075), (-2.325, 5.225), (-2.325, 8.075), (-2.25, 13.0)]
    assert np.array(leg.path) == pytest.approx(np.array(expected))


def test_worlds_come_in_the_order_of_their_numbers(tmp_path: Path) -> None:
    for number in (10, 9, 100):
        write_world(tmp_path, number)
    (tmp_path / "world_new.world").write_text("not a BARN number", encoding="utf-8")
    assert [world.name for world in barn_worlds(tmp_path)] == ["barn_9", "barn_10", "barn_100"]


@pytest.mark.parametrize("folder", [".", "nowhere"])
def test_folder_without_worlds_is_told(tmp_path: Path, folder: str) -> None:
    with pytest.raises(NotABarnFolder, match="no world_N"):
        barn_worlds(tmp_path / folder)


def test_world_without_its_path_is_told(tmp_path: Path) -> None:
    file = write_world(tmp_path, 1)
    (tmp_path / "path_1.npy").unlink()
    with pytest.raises(BrokenPath, match="there is no such file"):
        barn_world(file)


@pytest.mark.slow
def test_real_world_is_driven_to_its_goal_or_reported_stuck(
    shared_data: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """World 47 has 184 cylinders, none within 0.8 m of its path: nobody has to touch one."""
    worlds = {world.name: world for world in barn_worlds(shared_data / "barn")}
    assert list(worlds) == ["barn_0", "barn_47", "barn_123", "barn_201", "barn_299"]
    posts = [body for body in worlds["barn_47"].bodies if body.role == "wall"]
    assert len(posts) == 184
    path = worlds["barn_47"].routes[0].legs[0].path
    assert min(hypot(x - p.x, y - p.y) for x, y in path for p in posts) > 0.8
    (drive,) = drive_worlds([worlds["barn_47"]], ["none"])
    assert drive.outcome == "reached"
    assert drive.time_s < drive.limit_s == pytest.approx(3 * drive.route_length_m / 0.36)
    monkeypatch.setattr("sys.argv", ["omnistudy", "drive", "barn", str(shared_data)])
    with pytest.raises(SystemExit) as end:
        cli.main()
    assert end.value.code == 1
    assert "no world_N.world" in capsys.readouterr().err
