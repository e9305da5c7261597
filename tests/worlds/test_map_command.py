"""ROS maps and a lab's own worlds as a person types them."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from PIL import Image

from omnistudy.cli.app import main
from omnistudy.worlds import load_world

PAGE = """\
image: room.png
resolution: 0.25
origin: [-1.0, -1.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """A room of 4 m x 2.5 m in cells of 25 cm, one of them unknown."""
    image = Image.new("L", (16, 10), 0)
    image.paste(254, (1, 1, 15, 9))
    image.putpixel((1, 1), 205)
    image.save(tmp_path / "room.png")
    file = tmp_path / "room.yaml"
    file.write_text(PAGE, encoding="utf-8")
    return file


def test_a_map_is_imported_and_what_is_missing_is_said(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    room: Path,
    tmp_path: Path,
) -> None:
    page = tmp_path / "lab.yaml"
    assert run(monkeypatch, "world", "import", room, "-o", page) == 0
    said = capsys.readouterr().out
    assert "16 x 10 cells, 48 occupied" in said
    assert "1 unknown cells (1%) stay open" in said
    assert "the robot starts at the widest place, (0.12, 0.12)" in said
    assert "4 boxes, no route: add one under `routes`" in said
    assert run(monkeypatch, "world", "check", page) == 1
    assert "world 'lab' has no route: add one to its page" in capsys.readouterr().out
    assert run(monkeypatch, "world", "show", page) == 0
    assert "It has no route yet." in capsys.readouterr().out
    assert run(monkeypatch, "drive", "worlds", page, "--law", "none") == 1
    assert "has no route" in capsys.readouterr().err
    for options in ((), ("--grid",)):
        picture = tmp_path / f"plan{len(options)}.svg"
        assert run(monkeypatch, "world", "draw", page, "-o", picture, *options) == 0
    assert (tmp_path / "plan0.svg").read_bytes() != (tmp_path / "plan1.svg").read_bytes()


def test_a_map_is_never_imported_over_its_own_page(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], room: Path
) -> None:
    assert run(monkeypatch, "world", "import", room, "-o", room) == 1
    assert "--force" in capsys.readouterr().err
    assert room.read_text(encoding="utf-8") == PAGE


def test_a_goal_gives_a_route_that_passes_the_check(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    room: Path,
    tmp_path: Path,
) -> None:
    page, way = tmp_path / "lab.yaml", tmp_path / "way.csv"
    way.write_text("1.0,0.5\n", encoding="utf-8")
    given = ("--start", "0", "0", "0", "--goal", "2", "0.5", "--path", way)
    assert run(monkeypatch, "world", "import", room, "-o", page, *given) == 0
    assert "4 boxes, a route of 2.1 m" in capsys.readouterr().out  # 1.118 m and 1 m
    assert run(monkeypatch, "world", "check", page) == 0
    assert load_world(page).routes[0].legs[0].path == ((0, 0), (1, 0.5), (2, 0.5))


def test_wrong_usage_is_told_with_what_to_give(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    room: Path,
    tmp_path: Path,
) -> None:
    page, way = tmp_path / "lab.yaml", tmp_path / "way.csv"
    way.write_text("1.0,0.5\n", encoding="utf-8")
    assert run(monkeypatch, "world", "import", room, "-o", page, "--path", way) == 2
    assert "--goal X Y" in capsys.readouterr().err
    assert run(monkeypatch, "world", "import", tmp_path / "w.sdf", "-o", page) == 2
    assert "--start and --goal" in capsys.readouterr().err
    assert run(monkeypatch, "world", "import", tmp_path / "none.yaml", "-o", page) == 1
    assert "there is no such file" in capsys.readouterr().err
    assert not page.exists()


def test_a_lab_has_worlds_of_its_own(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    room: Path,
    tmp_path: Path,
) -> None:
    lab = tmp_path / "lab"
    (lab / "world").mkdir(parents=True)
    given = ("--start", "0", "0", "0", "--goal", "2", "0.5")
    assert run(monkeypatch, "world", "import", room, "-o", lab / "world" / "ours.yaml", *given) == 0
    monkeypatch.setenv("OMNISTUDY_CONF", str(lab))
    capsys.readouterr()
    assert run(monkeypatch, "world", "list", "--json") == 0
    listed = {row["name"]: row["file"] for row in json.loads(capsys.readouterr().out)}
    assert listed["ours"] == str(lab / "world" / "ours.yaml")
    assert "utah2017" in listed
    assert run(monkeypatch, "world", "show", "ours") == 0
    assert run(monkeypatch, "world", "check", "ours") == 0
    assert run(monkeypatch, "world", "draw", "ours", "-o", tmp_path / "ours.png") == 0
    assert "ours: no faults" in capsys.readouterr().out


def test_notes_of_moving_bodies_are_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "world", "check", "crossing") == 0
    # 0.25 m and half the robot either side of its way at 0.4 m/s, twice in each 24 s.
    assert "'trolley' is in the way for 4.4 s of every 24.0 s" in capsys.readouterr().out
    assert run(monkeypatch, "world", "check", "crossing", "--json") == 0
    assert len(json.loads(capsys.readouterr().out)["notes"]) == 4
