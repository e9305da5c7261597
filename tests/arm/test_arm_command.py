"""`omnistudy arm` as a person types it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.arm.run_file import read_run
from omnistudy.cli.app import main

NEAR = """
title: A little ahead
controller: {kind: pi_wln}
motions:
  - name: ahead
    goal: {frame: gripper, position: [0, 0, 0.05]}
"""


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", "arm", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


@pytest.fixture
def near(tmp_path: Path) -> Path:
    file = tmp_path / "near.yaml"
    file.write_text(NEAR, encoding="utf-8")
    return file


@pytest.fixture
def high(tmp_path: Path) -> Path:
    file = tmp_path / "high.yaml"
    text = NEAR.replace("frame: gripper, position: [0, 0, 0.05]", "position: [1, 0, 3]")
    file.write_text(text, encoding="utf-8")
    return file


def test_arms_and_tasks_are_listed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "list", "--json") == 0
    listed = json.loads(capsys.readouterr().out)
    assert [row["name"] for row in listed["arms"]] == ["wmra1", "wmra1_vr", "wmra2"]
    assert "door_right" in [row["name"] for row in listed["tasks"]]
    assert run(monkeypatch, "list") == 0
    assert "Take a book from the shelf" in capsys.readouterr().out


def test_an_arm_is_shown(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", "wmra1") == 0
    shown = capsys.readouterr().out
    assert "gripper: 0.131 m" in shown
    assert "shoulder" in shown
    assert run(monkeypatch, "show", "wmra1", "--json") == 0
    assert json.loads(capsys.readouterr().out)["chair"]["track"] == 0.56


def test_a_task_is_solved_and_drawn(
    near: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    csv, picture = tmp_path / "run.csv", tmp_path / "run.svg"
    assert run(monkeypatch, "solve", near, "-o", csv) == 0
    assert "wrote" in capsys.readouterr().out
    assert len(read_run(csv).steps) == 21
    assert run(monkeypatch, "plot", csv, "-o", picture, "--figure", "22") == 0
    assert picture.read_text().startswith("<?xml")


def test_another_controller_takes_every_motion(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    csv = tmp_path / "run.csv"
    arguments = ("solve", "door_left", "--controller", "sri_wln", "-o", csv, "--unchecked")
    assert run(monkeypatch, *arguments, "--json") == 0
    motions = json.loads(capsys.readouterr().out)
    assert [motion["motion"] for motion in motions] == ["approach", "opening"]
    # the task's own legacy controller ends 106.6 degrees off
    assert motions[1]["final_turn"] != pytest.approx(1.86, abs=0.01)


def test_what_is_there_is_not_overwritten(
    near: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    csv = tmp_path / "run.csv"
    csv.write_text("mine")
    assert run(monkeypatch, "solve", near, "-o", csv) == 1
    assert "--force" in capsys.readouterr().err
    assert csv.read_text() == "mine"
    assert run(monkeypatch, "solve", near, "-o", csv, "--force") == 0


def test_what_cannot_be_done_is_refused_and_nothing_is_written(
    high: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    csv = tmp_path / "run.csv"
    assert run(monkeypatch, "solve", high, "-o", csv) == 1
    said = capsys.readouterr().err
    assert "refused before anything moves" in said
    assert not csv.exists()
    assert run(monkeypatch, "check", high, "--json") == 1
    (answer,) = json.loads(capsys.readouterr().out)
    assert answer["possible"] is False
    assert 1.0 < answer["short"] < 2.5
    assert len(answer["chair"]) == 3


def test_a_check_says_from_where(
    near: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "check", near) == 0
    assert "can be reached from where the chair stands" in capsys.readouterr().out


def test_a_plan_is_told_and_then_run(
    near: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    csv, led = tmp_path / "run.csv", ("--controller", "dual_qp")
    assert run(monkeypatch, "check", near, *led, "--json") == 0
    (answer,) = json.loads(capsys.readouterr().out)
    assert answer["answer"].startswith("over the ground while the chair")
    assert answer["possible"] is True
    assert run(monkeypatch, "solve", near, *led, "-o", csv, "--json") == 0
    (motion,) = json.loads(capsys.readouterr().out)
    assert motion["final_error"] < 1e-5
    assert len(read_run(csv).steps) >= 21


def test_what_cannot_be_planned_is_refused_and_not_run_unchecked(
    high: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    csv, led = tmp_path / "run.csv", ("--controller", "dual_qp")
    assert run(monkeypatch, "check", high, *led) == 1
    assert "no chair pose was found" in " ".join(capsys.readouterr().out.split())
    assert run(monkeypatch, "solve", high, *led, "-o", csv) == 1
    assert "refused before anything moves" in capsys.readouterr().err
    assert run(monkeypatch, "solve", high, *led, "-o", csv, "--unchecked") == 2
    assert not csv.exists()


def test_a_urdf_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "wmra2.urdf"
    assert run(monkeypatch, "urdf", "wmra2", "-o", file) == 0
    assert '<robot name="wmra2">' in file.read_text()
    assert run(monkeypatch, "urdf", "wmra2", "-o", file) == 1
    assert "--force" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (("show", "wmra9"), 1, "no arm 'wmra9'"),
        (("check", "door"), 1, "no arm task 'door'"),
        (("solve", "reach", "--controller", "sri_wlm", "-o", "x.csv"), 1, "did you mean 'sri_wln'"),
        (("plot", "nothing.csv", "-o", "x.svg"), 1, "there is no such file"),
        (("plot", "nothing.csv", "-o", "x.svg", "--figure", "20"), 2, "no figure 20"),
    ],
)
def test_mistakes_are_one_clear_sentence(
    arguments: tuple[str, ...],
    status: int,
    said: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(monkeypatch, *arguments) == status
    assert said in capsys.readouterr().err
