"""A run as a CSV file and as pictures."""

from __future__ import annotations

import csv
from math import pi
from pathlib import Path

import pytest

from omnistudy.arm.drawing import FIGURES, write_figures
from omnistudy.arm.run import ArmRun
from omnistudy.arm.run_file import read_run, write_run
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import BrokenRun, RunExists, RunNotWritten
from omnistudy.session.solve_arm import solve_task


@pytest.fixture(scope="module")
def run() -> ArmRun:
    task = ArmTask.model_validate(
        {
            "controller": {"kind": "sri_wln", "zones": "none"},
            "motions": [
                {
                    "name": "out",
                    "goal": {"frame": "gripper", "position": [0, 0, 0.05]},
                    "chair_goal": {"x": 0.1},
                },
                {"name": "turn", "goal": {"turns": [{"axis": "z", "angle": pi / 8}]}},
                {
                    "name": "far",
                    "goal": {"position": [0.586, 0.6, 0.9]},
                    "speed": 2.0,
                    "pace": "hand",
                },
            ],
        }
    )
    return solve_task(task)


def test_what_is_written_is_read_back_to_the_last_digit(run: ArmRun, tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    write_run(run, file)
    again = read_run(file)
    assert repr(again) == repr(run)
    assert any(step.hits for step in run.steps)


def test_columns_are_named_and_one_row_is_one_step(run: ArmRun, tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    write_run(run, file)
    with file.open(newline="") as opened:
        rows = list(csv.DictReader(opened))
    assert len(rows) == len(run.steps)
    assert rows[0]["arm"] == "wmra1"
    assert {"q1", "q7", "hand_x", "chair_theta", "manipulability", "damping", "hits"} <= set(
        rows[0]
    )
    assert rows[-1]["chair_error"] == ""


def test_nothing_is_overwritten_unasked(run: ArmRun, tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    file.write_text("mine")
    with pytest.raises(RunExists, match="--force"):
        write_run(run, file)
    assert file.read_text() == "mine"
    write_run(run, file, replace=True)
    assert len(read_run(file).steps) == len(run.steps)


def test_a_folder_that_is_not_there(run: ArmRun, tmp_path: Path) -> None:
    with pytest.raises(RunNotWritten, match="No such file"):
        write_run(run, tmp_path / "nowhere" / "run.csv")


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("", "it holds no steps"),
        ("a,b\n1,2\n", "the column 'arm' is missing"),
        (b"\xff\xfe\x00", "cannot be read as CSV"),
        (None, "there is no such file"),
    ],
)
def test_a_file_that_is_no_run(tmp_path: Path, text: str | bytes | None, fault: str) -> None:
    file = tmp_path / "run.csv"
    if text is not None:
        file.write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(BrokenRun, match=fault):
        read_run(file)


def test_a_line_that_is_no_step(run: ArmRun, tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    write_run(run, file)
    lines = file.read_text().splitlines()
    lines[3] = lines[3].replace("wmra1,out,2,", "wmra1,out,two,")
    file.write_text("\n".join(lines))
    with pytest.raises(BrokenRun, match="line 4 is not a step"):
        read_run(file)


def test_every_figure_is_drawn_the_same_twice(run: ArmRun, tmp_path: Path) -> None:
    first, second = tmp_path / "a.svg", tmp_path / "b.svg"
    write_figures(run, first)
    write_figures(run, second)
    drawn = first.read_text()
    assert drawn == second.read_text()
    assert len(FIGURES) == 5


def test_one_figure_alone(run: ArmRun, tmp_path: Path) -> None:
    file = tmp_path / "one.png"
    write_figures(run, file, ("19",))
    assert file.read_bytes().startswith(b"\x89PNG")
