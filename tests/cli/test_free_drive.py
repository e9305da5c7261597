"""Driving freely from the command line, with the keys of a page, which need no hardware."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from session.live_stick import until

import omnistudy
from omnistudy.channel import LatestValue
from omnistudy.session.free_drive import DriveParts, drive_protocol
from omnistudy.view.live_files import state_file

COMMAND = (sys.executable, "-c", "from omnistudy.cli.app import main; main()", "drive")
KEYBOARD = ("primitive_a", "--device", "keyboard", "--no-open")


def drive(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*COMMAND, *arguments], cwd=folder, capture_output=True, text=True, check=False
    )


@pytest.mark.slow
def test_a_drive_is_kept_as_a_study_of_one_trial(tmp_path: Path) -> None:
    done = drive(tmp_path, *KEYBOARD, "--minutes", "0.02", "--json")
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    (file,) = (tmp_path / "studies" / "drives").glob("*")
    assert re.fullmatch(r"primitive_a_\d{4}-\d\d-\d\d_\d{6}\.db", file.name)
    assert told["file"] == str(file.relative_to(tmp_path))
    with omnistudy.open(file) as study:
        (row,) = study.trials().to_dict("records")
        assert (row["status"], row["task"], study.study.title) == (
            "completed",
            "free",
            "Free drive in primitive_a under component",
        )
        assert study.streams(1).set_index("name")["rows"]["stick"] > 0
        assert {"late_steps", "lost_rows"} <= set(study.measures(1)["name"])


@pytest.mark.slow
def test_ctrl_c_ends_a_drive_and_keeps_it(tmp_path: Path) -> None:
    file = tmp_path / "mine.db"
    process = subprocess.Popen(
        [*COMMAND, *KEYBOARD, "--output", str(file)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    until(lambda: state_file(file).exists() and _shown(file).get("t", 0.0) > 0.5)
    process.send_signal(signal.SIGINT)
    told, _ = process.communicate(timeout=60)
    assert process.returncode == 0
    assert told.startswith("aborted (stopped by hand)")
    with omnistudy.open(file) as study:
        assert list(study.trials()["status"]) == ["aborted"]
    assert [left.name for left in tmp_path.iterdir()] == ["mine.db"]


def _shown(study: Path) -> dict[str, float]:
    with LatestValue(state_file(study)) as state:
        value = state.read()
    shown: dict[str, float] = json.loads(value.data) if value else {}
    return shown


def test_a_mistake_leaves_no_file(tmp_path: Path) -> None:
    person = drive(tmp_path, "primitive_a", "--device", "emulated_stick", "--no-open")
    assert person.returncode == 1
    assert "no person can hold the simulated device 'emulated_stick'" in person.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_route_or_the_virtual_driver_has_somewhere_to_go() -> None:
    plain = DriveParts("primitive_a", "simulated_stick", "none")

    def task(parts: DriveParts) -> str:
        return drive_protocol(parts).task.kind

    assert task(plain) == "free"
    assert task(plain._replace(route="in-and-out")) == "route"
    assert task(plain._replace(hand="virtual")) == "route"
