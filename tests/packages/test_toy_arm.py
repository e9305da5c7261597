"""A laboratory brings its own robot in a package of its own; no file of ours changes.

The package has a seven-joint arm whose hand has a pose in space, a device with six axes, a
controller and a task, all announced through entry points. It is installed into a folder, and a
whole study runs from the command line and is read back.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.channel import SAMPLE_COLUMNS
from omnistudy.view.chromium import browser

pytestmark = pytest.mark.slow

PACKAGE = Path(__file__).parent / "omnistudy_toy_arm"
LAB = PACKAGE / "lab"
CUP = np.array([0.75, 0.15, 0.45])


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The package, installed where nothing else is."""
    folder = tmp_path_factory.mktemp("installed")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index"]
    subprocess.run(
        [*pip, "--no-build-isolation", "--target", str(folder), str(PACKAGE)],
        check=True,
        capture_output=True,
    )
    return folder


def python(installed: Path, here: Path, script: str, *arguments: str) -> str:
    """Run a script that finds the package and the laboratory's pages; give what it prints."""
    run = subprocess.run(
        [sys.executable, "-c", script, *arguments],
        cwd=here,
        env=os.environ
        | {
            "PYTHONPATH": str(installed),
            "OMNISTUDY_CONF": str(LAB),
            "OMNISTUDY_STUDIES": str(here / "studies"),
        },
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


COMMAND = "from omnistudy.cli.app import main; main()"


@pytest.fixture(scope="module")
def study(installed: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The laboratory's study, created and run from the command line by two processes."""
    here = tmp_path_factory.mktemp("laboratory")
    recording = f"operator.file={LAB / 'reach.csv'}"
    python(installed, here, COMMAND, "protocol", "check", "reaching", recording)
    python(installed, here, COMMAND, "study", "create", "reaching", recording)
    python(installed, here, COMMAND, "session", "run", "reaching", "--workers", "2")
    return here / "studies" / "reaching.db"


def test_the_package_is_no_part_of_this_environment() -> None:
    run = subprocess.run([sys.executable, "-c", "import omnistudy_toy_arm"], capture_output=True)
    assert run.returncode != 0


def test_its_kinds_are_named_beside_ours(installed: Path, tmp_path: Path) -> None:
    script = (
        "from omnistudy.registry import kinds\n"
        "print(kinds('plants'), kinds('controllers'), kinds('devices'), kinds('tasks'))"
    )
    named = python(installed, tmp_path, script)
    for kind in ("toy_arm", "youbot", "hand_rates", "six_axes", "reach"):
        assert f"'{kind}'" in named


def test_every_trial_reached_the_cup(study: Path) -> None:
    with omnistudy.open(study) as opened:
        trials = opened.trials()
    assert list(trials["status"]) == ["completed"] * 4
    assert set(trials["task"]) == {"reach"}
    for _, own in trials.groupby("participant"):
        assert sorted(own["condition"]) == ["fast", "slow"]
    duration = trials.groupby("condition")["duration_s"].mean()
    assert duration["fast"] < 0.6 * duration["slow"]
    assert (trials["collisions"] == 0).all()


def test_the_pose_in_space_is_read_back_from_its_stream(study: Path) -> None:
    with omnistudy.open(study) as opened:
        for trial in opened.trials()["trial"]:
            arm = opened.stream(trial, "plant")
            hand = arm[["hand_x", "hand_y", "hand_z"]].to_numpy()
            assert np.linalg.norm(hand[0] - CUP) > 0.2
            assert np.linalg.norm(hand[-1] - CUP) < 0.05 + 0.02
            turn = arm[["hand_qx", "hand_qy", "hand_qz", "hand_qw"]].to_numpy()
            assert np.allclose(np.linalg.norm(turn, axis=1), 1.0)
            assert arm.attrs["units"]["joint_7"] == "rad"
            way = np.linalg.norm(np.diff(hand, axis=0), axis=1).sum()
            stored = opened.trials().set_index("trial").loc[trial, "path_length_m"]
            assert stored == pytest.approx(way, rel=0.1)


def test_what_an_arm_has_not_is_nan_in_its_samples(study: Path) -> None:
    with omnistudy.open(study) as opened:
        samples = opened.sample_array(opened.trials()["trial"][0])
    missing = [SAMPLE_COLUMNS.index(name) for name in SAMPLE_COLUMNS if name not in
               ("t", "fx", "fy", "tau")]  # fmt: skip
    assert np.isnan(samples[:, missing]).all()


def test_the_clock_starts_with_a_push_that_no_floor_robot_knows(study: Path) -> None:
    # the recording begins with half a second of rest, then a push straight down
    with omnistudy.open(study) as opened:
        events = opened.events()
    starts = events[events["kind"] == "start"]
    assert len(starts) == 4
    assert starts["t"].to_numpy() == pytest.approx(0.5, abs=2 / 240)


RESIMULATE = """
import sys
import omnistudy
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session.specs import trial_spec
from omnistudy.store import StudyWriter
from omnistudy.trial import resimulate

path, recording = sys.argv[1:]
protocol = compose_protocol("reaching", [recording])
with StudyWriter.open(path) as writer:
    trials = writer.trials()
with omnistudy.open(path) as study:
    for trial in trials:
        given = study.stream_record(trial.id, "input").data
        again = resimulate(trial_spec(protocol, trial), given)
        assert again.samples.tobytes() == study.sample_array(trial.id).tobytes()
        print(trial.id, again.status)
"""


def test_its_trials_resimulate_from_the_database(
    installed: Path, study: Path, tmp_path: Path
) -> None:
    printed = python(
        installed, tmp_path, RESIMULATE, str(study), f"operator.file={LAB / 'reach.csv'}"
    )
    assert printed.split() == [part for n in range(1, 5) for part in (str(n), "completed")]


def test_its_gains_are_swept_by_workers_of_their_own(installed: Path, tmp_path: Path) -> None:
    asked = ("reaching", "controller.gain=3,6", f"operator.file={LAB / 'reach.csv'}")
    options = ("--condition", "slow", "--name", "gains", "--launcher", "joblib", "--workers", "2")
    python(installed, tmp_path, COMMAND, "sweep", *asked, *options)
    shown = python(installed, tmp_path, COMMAND, "sweep", "show", "--by", "duration_s", "--json")
    ranking = json.loads(shown)
    assert [point["values"] for point in ranking["points"]] == [[6], [3]]
    assert ranking["points"][0]["outcomes"]["work_against_j"] is None, "it has no motors"


SEEN = """(() => {
  const {stage, record} = window.replay.player.reels[0];
  const {frame} = stage.robot.moving[6];
  frame.updateWorldMatrix(true, false);
  return frame.localToWorld(frame.position.clone().set(0, 0, 0.13)).toArray();
})()"""
"""Where the page draws the end of the last link."""


def test_its_arm_moves_in_a_replay_as_it_did(
    installed: Path,
    study: Path,
    tmp_path: Path,
    requires_program: Callable[[str, str], str],
) -> None:
    requires_program("chromium", "chromium")
    page = tmp_path / "arm.html"
    python(installed, tmp_path, COMMAND, "replay", str(study), "1", "-o", str(page))
    with omnistudy.open(study) as opened:
        arm = opened.stream(1, "plant")
    with browser() as running:
        tab = running.tab()
        tab.open(page.as_uri())
        tab.wait_for("window.replay !== undefined")
        for row in (0, len(arm) // 2, len(arm) - 1):
            tab.value(f"window.replay.seek({arm['t'].iloc[row]})")
            hand = arm[["hand_x", "hand_y", "hand_z"]].iloc[row]
            assert tab.value(SEEN) == pytest.approx(list(hand), abs=1e-3)
        assert tab.faults == []
