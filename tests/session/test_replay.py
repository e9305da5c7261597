"""A recorded drive beside its odometry: made-up drives with known answers, and real people's."""

from __future__ import annotations

import json
from math import cos, inf, isfinite, pi, sin
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omnistudy.cli import app as cli
from omnistudy.errors.drive import (
    BrokenPart,
    NoCommonTime,
    NotAColumn,
    NothingMapped,
    UnknownPart,
)
from omnistudy.operators.recorded import RecordedOperator
from omnistudy.session.columns import mapped
from omnistudy.session.odometry import Odometry, compare, read_odometry
from omnistudy.session.parts import part
from omnistudy.session.replay import recorded_twists, replay

T0 = 1_627_303_132.5
"""A stamp as robots write them, s since 1970."""


def circle(t: np.ndarray, v: float = 0.2, omega: float = 0.5) -> np.ndarray:
    """Poses of a drive on a circle from the origin, (n, 3)."""
    radius = v / omega
    return np.column_stack(
        [radius * np.sin(omega * t), radius * (1 - np.cos(omega * t)), omega * t]
    )


def seen_from(poses: np.ndarray, x: float, y: float, theta: float) -> np.ndarray:
    """The same drive in a map in which it starts at another pose."""
    c, s = cos(theta), sin(theta)
    return np.column_stack(
        [
            x + c * poses[:, 0] - s * poses[:, 1],
            y + s * poses[:, 0] + c * poses[:, 1],
            poses[:, 2] + theta,
        ]
    )


def odometry(times: np.ndarray, poses: np.ndarray) -> Odometry:
    return Odometry(Path("odom.csv"), times, poses)


@pytest.fixture
def drive_files(tmp_path: Path) -> tuple[Path, Path]:
    """A drive of 3 s on a circle between two rests, and its odometry in a map of its own."""
    commands, own = tmp_path / "commands.csv", tmp_path / "odom.csv"
    commands.write_text(
        f"time,v,omega\n{T0 - 5},0,0\n{T0},0.2,0.5\n{T0 + 3},0,0\n{T0 + 9},0,0\n", encoding="utf-8"
    )
    t = np.arange(-4.0, 6.0, 0.043)
    poses = seen_from(circle(np.clip(t, 0.0, 3.0)), 4.0, -2.0, 3.0)
    rows = [
        f"{T0 + stamp:.6f},{x:.6f},{y:.6f},{(theta + pi) % (2 * pi) - pi:.6f}"
        for stamp, (x, y, theta) in zip(t, poses, strict=True)
    ]
    own.write_text("\n".join(["time,x,y,yaw", *rows]), encoding="utf-8")
    return commands, own


def test_perfect_odometry_is_met(drive_files: tuple[Path, Path]) -> None:
    """Its map starts elsewhere and its yaw passes a half turn; neither matters."""
    commands, own = drive_files
    result = replay(RecordedOperator(file=commands), "direct", odometry=read_odometry(own))
    found = result.odometry
    assert found is not None
    assert result.duration_s == pytest.approx(3.0)
    assert found.path_length_m == pytest.approx(0.6, abs=0.001)
    assert found.turned_rad == pytest.approx(1.5, abs=0.001)
    assert found.end_error_m < 0.005
    assert found.largest_error_m < 0.005
    assert abs(found.heading_error_rad) < 0.01


def test_errors_are_those_of_a_known_drive() -> None:
    """The simulated robot goes straight on for 2 m, the person's turned left after 1 m."""
    t = np.linspace(0.0, 10.0, 11)
    straight = np.column_stack([0.2 * t, 0 * t, 0 * t])
    turned = np.array([(min(0.2 * s, 1.0), max(0.0, 0.2 * s - 1.0), pi / 2 * (s > 5)) for s in t])
    found = compare(odometry(T0 + t, turned), T0, t, straight)
    assert found.end_error_m == pytest.approx(np.sqrt(2.0))
    assert found.end_error_share == pytest.approx(np.sqrt(2.0) / 2.0)
    assert found.heading_error_rad == pytest.approx(-pi / 2)
    assert found.path_length_m == pytest.approx(2.0)
    assert (found.largest_error_m, found.largest_error_at_s) == pytest.approx((np.sqrt(2), 10))


def test_largest_error_need_not_be_the_last() -> None:
    t = np.array([0.0, 1.0, 2.0])
    away = np.array([(0.0, 0.0, 0.0), (1.0, 3.0, 0.0), (2.0, 0.0, 0.0)])
    straight = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0)])
    found = compare(odometry(t, away), 0.0, t, straight)
    assert (found.end_error_m, found.largest_error_m, found.largest_error_at_s) == (0.0, 3.0, 1.0)


def test_what_the_odometry_sees_after_the_drive_counts() -> None:
    """A robot that rolls on after its last command ends where it comes to rest."""
    t = np.array([0.0, 1.0])
    drive = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)])
    own = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.5, 0.0, 0.0)])
    found = compare(odometry(np.array([0.0, 1.0, 2.0]), own), 0.0, t, drive)
    assert found.end_error_m == pytest.approx(0.5)


@given(
    x=st.floats(-100, 100),
    y=st.floats(-100, 100),
    theta=st.floats(-20, 20),
    lag=st.floats(0.0, 0.5),
)
@settings(deadline=None)
def test_where_a_map_has_its_origin_changes_nothing(
    x: float, y: float, theta: float, lag: float
) -> None:
    t = np.linspace(0.0, 6.0, 61)
    own, drive = circle(t), circle(np.maximum(t - lag, 0.0))
    plain = compare(odometry(t, own), 0.0, t, drive)
    moved = compare(odometry(t, seen_from(own, x, y, theta)), 0.0, t, seen_from(drive, y, x, -x))
    for a, b in (
        (plain.end_error_m, moved.end_error_m),
        (plain.heading_error_rad, moved.heading_error_rad),
        (plain.largest_error_m, moved.largest_error_m),
        (plain.path_length_m, moved.path_length_m),
    ):
        assert a == pytest.approx(b, abs=1e-9)


def test_robot_that_never_moved_has_no_share() -> None:
    t = np.array([0.0, 1.0])
    found = compare(odometry(t, np.zeros((2, 3))), 0.0, t, circle(t))
    assert found.end_error_share == inf


@pytest.mark.parametrize("began", [-20.0, 20.0])
def test_odometry_of_another_time_is_refused(began: float) -> None:
    t = np.array([0.0, 1.0])
    with pytest.raises(NoCommonTime, match="same drive"):
        compare(odometry(t, circle(t)), began, t, circle(t))


def test_columns_are_laid_over_the_defaults() -> None:
    names = {"time": "time", "x": "v", "y": None}
    assert mapped((), names) == ("time", "v", None)
    assert mapped(("x=none", "y = left", "time=stamp"), names) == ("stamp", None, "left")
    for wrong in ("z=v", "x", "x=", "=v"):
        with pytest.raises(NotAColumn, match="time, x, y"):
            mapped((wrong,), names)
    for columns in ((None, "v"), ("time", None, None)):
        with pytest.raises(NothingMapped):
            recorded_twists(Path("x.csv"), columns)


def test_parts_come_from_pages_and_the_lab_s_come_first(tmp_path: Path) -> None:
    assert part("law", "component").kind == "component"
    assert part("messages", "en").good_job == "Good Job"
    (tmp_path / "law").mkdir()
    page = tmp_path / "law" / "component.yaml"
    page.write_text("kind: none\n", encoding="utf-8")
    assert part("law", "component", tmp_path).kind == "none"
    page.write_text("kind: component\ncompliance_center: 0.1\n", encoding="utf-8")
    with pytest.raises(
        BrokenPart, match=r"conf/law/component.yaml: compliance_center: unknown key"
    ):
        part("law", "component", tmp_path)
    with pytest.raises(UnknownPart, match="did you mean 'component'"):
        part("law", "componnt")


# The command


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int | str | None:
    monkeypatch.setattr("sys.argv", ["omnistudy", "drive", *arguments])
    with pytest.raises(SystemExit) as end:
        cli.main()
    return end.value.code


def test_command_prints_a_row_for_each_controller(
    drive_files: tuple[Path, Path],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    commands, own = map(str, drive_files)
    assert not run(monkeypatch, "replay", commands, "--odometry", own)
    said = capsys.readouterr().out
    assert "direct" in said
    assert "differential" in said
    assert "end error m" in said
    assert "could not follow" not in said


def test_command_gives_json(
    drive_files: tuple[Path, Path],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    commands, own = map(str, drive_files)
    line = ("replay", commands, "--odometry", own, "--controller", "direct", "--json")
    assert not run(monkeypatch, *line)
    (drive,) = json.loads(capsys.readouterr().out)
    assert drive["odometry"]["end_error_m"] < 0.005


def test_command_says_when_a_robot_could_not_follow(
    drive_files: tuple[Path, Path],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    commands, own = drive_files
    commands.write_text(commands.read_text().replace("0.2,0.5", "1.0,0.5"), encoding="utf-8")
    assert not run(monkeypatch, "replay", str(commands), "--odometry", str(own))
    assert "it could not follow them" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (("--column", "theta=omga"), "did you mean 'omega'"),
        (("--column", "x"), "maps no column"),
        (("--world", "nowhere"), "no world 'nowhere'"),
        (("--controller", "directt"), "did you mean 'direct'"),
        (("--odometry", "nowhere.csv"), "there is no such file"),
    ],
)
def test_command_tells_mistakes_in_one_line(
    drive_files: tuple[Path, Path],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    more: tuple[str, ...],
    said: str,
) -> None:
    assert run(monkeypatch, "replay", str(drive_files[0]), *more) == 1
    told = [line for line in capsys.readouterr().err.splitlines() if line.startswith("error:")]
    assert len(told) == 1
    assert said in told[0]


# Real people


@pytest.mark.slow
@pytest.mark.slow
def test_real_drives_end_where_physics_lets_them(shared_data: Path) -> None:
    """Robust facts only: nothing here is fitted to the four drives.

    What the TurtleBot's wheels measured, driven again, is the test of the simulation: it ends
    within 10 % of the path (rows of every 43 ms were stamped on arrival, 0 to 0.17 s apart). The
    commands ask for up to 1 m/s, which that robot cannot reach: they are only sure to overshoot.
    """
    drives = sorted((shared_data / "human-driving").glob("*/*/odom.csv"))
    assert len(drives) == 4
    for file in drives:
        own = read_odometry(file)
        measured = replay(RecordedOperator(file=file), "direct", odometry=own).odometry
        assert measured is not None
        assert measured.end_error_share < 0.1
        operator = RecordedOperator(file=file.with_name("twist_cmd_vel.csv"))
        asked = replay(operator, "direct", odometry=own)
        assert asked.odometry is not None
        assert asked.path_length_m > 3.0 * asked.odometry.path_length_m
        wheels = replay(operator, "differential", odometry=own)
        assert wheels.odometry is not None
        assert isfinite(wheels.odometry.end_error_m)
        assert wheels.odometry.end_error_m < asked.odometry.end_error_m
        assert wheels.path_length_m == pytest.approx(wheels.odometry.path_length_m, rel=0.1)
