"""`omnistudy world` as a person types it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli.app import main
from omnistudy.worlds import load_world, world_file

SDF = (
    "<sdf version='1.6'><world name='w'><model name='crate'><pose>2 1 0.5 0 0 0</pose>"
    "<link name='l'><collision name='c'><geometry><box><size>1 1 1</size></box></geometry>"
    "</collision></link></model></world></sdf>"
)


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_worlds_are_listed_and_shown(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "world", "list", "--json") == 0
    names = [row["name"] for row in json.loads(capsys.readouterr().out)]
    assert {"utah2017", "primitive_a", "primitive_b", "primitive_c"} <= set(names)
    assert run(monkeypatch, "world", "show", "utah2017") == 0
    shown = capsys.readouterr().out
    assert "red > green > blue > finish" in shown


@pytest.mark.parametrize("suffix", [".svg", ".png"])
def test_plan_is_drawn_twice_alike_and_never_over_a_file(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    suffix: str,
) -> None:
    first, second = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    for picture in (first, second):
        assert run(monkeypatch, "world", "draw", "primitive_b", "-o", picture) == 0
    assert first.read_bytes() == second.read_bytes()
    assert len(first.read_bytes()) > 5000
    assert run(monkeypatch, "world", "draw", "primitive_b", "-o", first) == 1
    assert "--force" in capsys.readouterr().err
    assert run(monkeypatch, "world", "draw", "primitive_b", "-o", tmp_path / "a.gif") == 1
    assert ".svg or .png" in capsys.readouterr().err
    nowhere = tmp_path / "nowhere" / f"a{suffix}"
    assert run(monkeypatch, "world", "draw", "primitive_b", "-o", nowhere) == 1
    assert "cannot be written" in capsys.readouterr().err


def test_check_prints_each_route_and_exits_1_on_a_fault(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert run(monkeypatch, "world", "check", "utah2017", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert [route["name"] for route in found["routes"]] == [
        "red-green-blue",
        "red-blue-green",
        "blue-green-red",
    ]
    assert found["plant_width"] == 0.38
    page = tmp_path / "broken.yaml"
    text = world_file("primitive_b").read_text(encoding="utf-8")
    page.write_text(text.replace("start: {x: 0.0, y: 0.0", "start: {x: 0.4, y: 0.4"), "utf-8")
    assert run(monkeypatch, "world", "check", page) == 1
    assert "starts in wall" in capsys.readouterr().out


def test_unknown_world_and_broken_page_are_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert run(monkeypatch, "world", "show", "utah2071") == 1
    assert "did you mean 'utah2017'?" in capsys.readouterr().err
    page = tmp_path / "bad.yaml"
    page.write_text("name: [", encoding="utf-8")
    assert run(monkeypatch, "world", "check", page) == 1
    assert "not readable as YAML" in capsys.readouterr().err


def test_an_imported_world_is_checked_drawn_and_never_overwritten(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    file, page, path = tmp_path / "w.sdf", tmp_path / "crates.yaml", tmp_path / "path.csv"
    file.write_text(SDF, encoding="utf-8")
    path.write_text("0,0\n10,0\n", encoding="utf-8")
    options = ("--start", "-1", "0", "0", "--goal", "4", "0", "--path", path)
    grid = ("--path-grid", "0.2", "0.5", "0")
    assert run(monkeypatch, "world", "import", file, "-o", page, *options, *grid) == 0
    assert "1 obstacles, a route of 5.0 m" in capsys.readouterr().out
    world = load_world(page)
    assert world.routes[0].legs[0].path == ((-1.0, 0.0), (0.5, 0.0), (2.5, 0.0), (4.0, 0.0))
    assert [(body.name, body.x, body.y) for body in world.bodies if body.role == "wall"] == [
        ("crate", 2.0, 1.0)
    ]
    assert run(monkeypatch, "world", "check", page) == 0
    assert run(monkeypatch, "world", "draw", page, "-o", tmp_path / "crates.svg") == 0
    before = page.read_bytes()
    assert run(monkeypatch, "world", "import", file, "-o", page, *options) == 1
    assert page.read_bytes() == before
    capsys.readouterr()
    nowhere = tmp_path / "nowhere" / "crates.yaml"
    assert run(monkeypatch, "world", "import", file, "-o", nowhere, *options) == 1
    assert "cannot be written" in capsys.readouterr().err
