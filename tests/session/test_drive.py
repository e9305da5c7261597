"""The virtual driver in worlds without a study: reached, stuck where, the same on any cores."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from core_world import block, straight_world, wall

from omnistudy.cli import app as cli
from omnistudy.errors.drive import UnknownPart
from omnistudy.errors.plants import StartsInWall
from omnistudy.session.drive import Drive, drive_worlds
from omnistudy.worlds import Leg, Route, Start, World


def closed_world() -> World:
    """A wall across the way to the block."""
    return World(
        name="closed",
        start=Start(x=0.0, y=0.0),
        bodies=(wall("shut", (1.0, -3.0), (1.0, 3.0)), block("red", 3.0, 0.0)),
        routes=(Route(name="through", legs=(Leg(target="red", path=((0, 0), (3, 0))),)),),
    )


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int | str | None:
    monkeypatch.setattr("sys.argv", ["omnistudy", "drive", *arguments])
    with pytest.raises(SystemExit) as end:
        cli.main()
    return end.value.code


def test_way_that_is_open_is_reached() -> None:
    (drive,) = drive_worlds([straight_world()], ["none"])
    assert drive.outcome == "reached"
    assert drive.route_length_m == 2.0
    assert drive.limit_s == pytest.approx(3 * 2.0 / 0.36)
    assert drive.time_s < drive.limit_s
    assert 1.5 < drive.along_m <= 2.0


def test_way_that_is_shut_is_stuck_at_the_wall() -> None:
    """Its front is 0.29 m ahead of its centre, the wall's face at 0.95 m."""
    (drive,) = drive_worlds([closed_world()], ["none"])
    assert drive.outcome == "stuck"
    assert drive.time_s == pytest.approx(25.0, abs=0.1)
    assert drive.x == pytest.approx(0.95 - 0.29, abs=0.1)
    assert drive.along_m == pytest.approx(drive.x)
    assert 1.0 < drive.along_at_s < 25.0
    assert drive.wall == "shut"
    assert drive.collisions > 0


@pytest.mark.slow
def test_drives_are_the_same_on_one_core_and_two() -> None:
    worlds = [straight_world(1.5), closed_world()]
    told: list[Drive] = []
    alone = drive_worlds(worlds, ["component", "none"], driven=told.append)
    both = drive_worlds(worlds, ["component", "none"], workers=2)
    assert alone == both == tuple(told)
    assert [(drive.world, drive.law) for drive in alone] == [
        ("straight", "component"),
        ("straight", "none"),
        ("closed", "component"),
        ("closed", "none"),
    ]


@pytest.mark.slow
def test_seed_is_another_person() -> None:
    times = {drive_worlds([straight_world()], ["none"], seed=seed)[0].time_s for seed in (1, 2, 1)}
    assert len(times) == 2


def test_worlds_that_cannot_be_driven_are_told() -> None:
    with pytest.raises(UnknownPart, match="no law 'componnt'"):
        drive_worlds([straight_world()], ["componnt"])
    inside = closed_world().model_copy(update={"start": Start(x=1.0, y=0.0)})
    with pytest.raises(StartsInWall, match="shut"):
        drive_worlds([inside], ["none"])


@pytest.mark.slow
def test_command_drives_worlds_by_name(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    line = ("worlds", "primitive_b", "--law", "none", "--workers", "1")
    assert not run(monkeypatch, *line)
    said = capsys.readouterr()
    assert "primitive_b" in said.out
    assert "reached" in said.out
    assert not run(monkeypatch, *line, "--json")
    (drive,) = json.loads(capsys.readouterr().out)
    assert (drive["world"], drive["law"]) == ("primitive_b", "none")


def test_command_says_where_a_robot_is_stuck(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "closed.yaml"
    page.write_text(closed_world().model_dump_json(), encoding="utf-8")
    assert not run(monkeypatch, "worlds", str(page), "--law", "none", "--workers", "1")
    assert "closed under none: stuck 0.6" in capsys.readouterr().out
