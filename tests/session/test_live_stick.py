"""Trials in real time on the emulated stick, turned by a process of its own.

Nothing here is about how quick the machine is: counts, what belongs together, and what happens when
a part dies.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from multiprocessing import active_children
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from session.live_stick import FOUR_SECONDS, drive, make_study, until

import omnistudy
from omnistudy.devices.stick.toolchain import missing_packages
from omnistudy.errors.session import AlwaysVoid
from omnistudy.session import run_trials
from omnistudy.session.held_devices import HeldDevices
from omnistudy.session.live import RealTime, run_live
from omnistudy.session.run import INTERRUPTED
from omnistudy.session.specs import trial_spec
from omnistudy.store import StoredTrial, StudyWriter
from omnistudy.study.frozen import frozen_protocol
from omnistudy.trial import TrialResult, resimulate
from omnistudy.view.attendance import attended

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module", autouse=True)
def toolchain() -> None:
    """Skip where the emulator cannot be compiled."""
    missing = missing_packages()
    if missing:
        packages = ", ".join(dict.fromkeys(missing.values()))
        pytest.skip(f"needs {', '.join(missing)}: `make system-packages` ({packages})")


@pytest.fixture
def short(tmp_path: Path) -> Path:
    """A study whose trials are cut off after some four seconds."""
    return make_study(tmp_path / "short.db", FOUR_SECONDS)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study whose first trial was driven live from start to finish."""
    study = make_study(tmp_path_factory.mktemp("live") / "whole.db")
    drive(study)
    return study


def ticks_of(study: Path, trial: int) -> np.ndarray:
    with omnistudy.open(study) as opened:
        return opened.stream(trial, "stick")["stick_tick"].to_numpy()


def test_a_whole_trial_is_driven_and_tells_how_it_went(whole: Path) -> None:
    with omnistudy.open(whole) as study:
        trials = study.trials()
        first = trials[trials["status"] != "planned"].iloc[-1]
        number = int(first["trial"])
        told = dict(study.measures(number)[["name", "value"]].itertuples(index=False))
        (device,) = study.devices()[lambda table: table["trial"] == number].to_dict("records")
    assert first["status"] in ("completed", "timed_out")
    assert told["device_turns"] >= 1000 * first["duration_s"]
    assert told["turn_lateness_p50"] <= told["turn_lateness_p99"]
    assert {"late_steps", "late_turns", "late_fields", "dropped_frames"} <= set(told)
    assert told["check_emergency_stop_pressed"] == 1.0
    assert (device["kind"], device["wrench"], device["scale"]) == (
        "emulated_stick",
        "clipped",
        "nominal",
    )
    assert device["pushes"] == "stick_x stick_y stick_theta"


def test_every_tick_of_a_trial_is_in_the_study(whole: Path) -> None:
    with omnistudy.open(whole) as study:
        trials = study.trials()
        number = int(trials[trials["status"] != "planned"].iloc[-1]["trial"])
        told = dict(study.measures(number)[["name", "value"]].itertuples(index=False))
        stick = study.stream(number, "stick")
        rows = study.streams(number).set_index("name")["rows"]
    assert (np.diff(stick["stick_tick"]) == 1).all()
    assert (np.diff(stick["heard_at"]) >= 0).all()
    assert len(stick) == told["recorded_rows"] == rows["stick"]
    assert told["lost_rows"] == 0


def test_it_simulates_again_from_its_input_to_the_same_bytes(whole: Path) -> None:
    with StudyWriter.open(whole) as writer:
        protocol = frozen_protocol(writer.study)
        (trial,) = [one for one in writer.trials() if one.status not in ("planned", "void")]
    with omnistudy.open(whole) as study:
        recorded = study.stream_record(trial.id, "input").data
        samples = study.sample_array(trial.id)
    again = resimulate(trial_spec(protocol, trial), recorded)
    assert (again.samples + 0.0).tobytes() == samples.tobytes()  # SQLite keeps no -0.0


def test_a_killed_recorder_costs_no_row_and_is_told(short: Path) -> None:
    def kill(devices: HeldDevices) -> None:
        assert devices.recorder is not None
        os.kill(devices.recorder.process_id, signal.SIGKILL)

    drive(short, meddle=kill)
    with omnistudy.open(short) as study:
        trials = study.trials()
        number = int(trials[trials["status"] == "timed_out"].iloc[0]["trial"])
        told = dict(study.measures(number)[["name", "value"]].itertuples(index=False))
        kinds = list(study.events(number)["kind"])
    assert "recorder" in kinds
    assert told["lost_rows"] == 0
    assert (np.diff(ticks_of(short, number)) == 1).all()


def test_the_monitor_hears_how_the_stick_does_and_pages_where_it_stands(short: Path) -> None:
    seen: dict[str, Any] = {}
    with attended(short) as attendance, HeldDevices(short) as devices:
        assert devices.deflection() is None

        def accompany(trial: StoredTrial) -> RealTime:
            return attendance.accompany(trial, devices.measures)

        def look(trial: StoredTrial, result: TrialResult) -> None:
            state, _ = attendance.meeting()
            found = state.read()
            assert found is not None
            seen.update(json.loads(found.data))
            seen["deflection"] = devices.deflection()

        run_trials(
            short,
            limit=1,
            run=lambda ready, specs: run_live(ready, specs, accompany, devices),
            finished=look,
        )
    assert len(seen["deflection"]) == 3
    assert all(-1.0 <= share <= 1.0 for share in seen["deflection"])
    assert any(seen["deflection"])
    health = {reading["name"]: reading for reading in seen["health"]}
    assert {"late steps", "turn lateness p99", "dropped frames", "late fields"} <= set(health)
    assert health["dropped frames"] == {
        "name": "dropped frames", "value": 0.0, "unit": "", "ok": True,
    }  # fmt: skip
    assert health["turn lateness p99"]["unit"] == "ms"
    assert any(name.startswith("saturated stick") for name in health)


def test_a_killed_page_server_is_not_even_noticed(short: Path) -> None:
    others = set(active_children())
    with attended(short) as attendance, HeldDevices(short) as devices:
        (server,) = set(active_children()) - others

        def accompany(trial: StoredTrial) -> RealTime:
            publisher = attendance.accompany(trial)
            server.kill()
            server.join()
            return publisher

        summary = run_trials(
            short, limit=1, run=lambda ready, specs: run_live(ready, specs, accompany, devices)
        )
    assert not server.is_alive()
    assert (summary.timed_out, summary.aborted) == (1, 0)
    with omnistudy.open(short) as study:
        trials = study.trials()
        number = int(trials[trials["status"] == "timed_out"].iloc[0]["trial"])
    assert (np.diff(ticks_of(short, number)) == 1).all()


def test_a_killed_device_process_voids_the_attempt_and_another_is_driven(short: Path) -> None:
    def kill(devices: HeldDevices) -> None:
        assert devices.remote is not None
        os.kill(devices.remote.process_id, signal.SIGKILL)

    summary = drive(short, meddle=kill)
    assert summary.void >= 1
    with omnistudy.open(short) as study:
        own = study.trials()[lambda table: table["position"] == 1]
        first, *_, last = own.to_dict("records")
        before, after = study.sample_array(first["trial"]), study.sample_array(last["trial"])
    assert first["status"] == "void"
    assert "ended with exit code -9" in first["reason"]
    assert last["status"] == "timed_out"
    assert last["attempt"] == len(own)
    assert first["seed"] != last["seed"]
    assert len(ticks_of(short, first["trial"])) > 500
    assert 0 < len(before) < len(after)


def test_a_stick_that_always_ails_ends_the_session(
    short: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("omnistudy.session.run.MOST_ATTEMPTS", 1)

    def kill(devices: HeldDevices) -> None:
        assert devices.remote is not None
        os.kill(devices.remote.process_id, signal.SIGKILL)

    with pytest.raises(AlwaysVoid, match="trial 1 of P01 was void 1 times in a row"):
        drive(short, meddle=kill)
    with omnistudy.open(short) as study:
        own = study.trials()[lambda table: table["position"] == 1]
    assert list(own["status"]) == ["void", "planned"]


def test_a_killed_simulation_leaves_what_was_recorded_and_another_attempt(short: Path) -> None:
    code = (
        "import os, signal, sys; from pathlib import Path; from session.live_stick import drive\n"
        "if __name__ == '__main__':\n"
        "    drive(Path(sys.argv[1]), after=2.5,"
        " meddle=lambda devices: os.kill(os.getpid(), signal.SIGKILL))\n"
    )
    script = short.with_name("simulation.py")
    script.write_text(code)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    killed = subprocess.run([sys.executable, str(script), str(short)], env=environment, check=False)
    assert killed.returncode == -signal.SIGKILL

    def recorded() -> int:
        with omnistudy.open(short) as study:
            return int(study.streams(1)["rows"].sum()) if len(study.streams(1)) else 0

    until(lambda: recorded() > 2000)
    drive(short)
    with omnistudy.open(short) as study:
        own = study.trials()[lambda table: table["position"] == 1]
    first, *_, last_attempt = own.to_dict("records")
    assert (first["status"], first["reason"]) == ("void", INTERRUPTED)
    assert last_attempt["status"] == "timed_out"
    assert (np.diff(ticks_of(short, first["trial"])) == 1).all()
