"""The emulated stick turned by a process of its own: orders, rows, and what happens when one dies.

Nothing here is about how quick it is: the machine may be busy.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from omnistudy.channel import LatestValue, Ring
from omnistudy.channel.trial_row import TRIAL_ROW
from omnistudy.devices import Hand
from omnistudy.devices.device_process import Files
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.orders import ReportLayout
from omnistudy.devices.remote_device import RemoteDevice
from omnistudy.errors.devices import NotReached
from omnistudy.geometry import ForceField, PlanarWrench

GRIP = Hand((0.01, -0.008, 0.3), (400.0, 400.0, 20.0), (20.0, 20.0, 0.5), (0.8, 0.8, 0.003))
PUSH = ForceField(PlanarWrench(3.0, 0.0, 0.0), valid_for=0.25)


def until(happened: Callable[[], object]) -> None:
    """Wait for something that must happen, however busy the machine is."""
    end = time.monotonic() + 60.0
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.005)


@pytest.fixture(scope="module")
def stick(toolchain: None) -> Iterator[RemoteDevice]:
    with RemoteDevice(EmulatedStickDevice()) as remote:
        yield remote


def drive(stick: RemoteDevice, trial: int, turns: int) -> None:
    """Hold the stick and push until its process has turned so often."""
    stick.open_trial(trial)
    end = stick.report.turn + turns

    def pushed() -> bool:
        stick.render(PUSH)
        stick.advance(GRIP)
        assert stick.trouble() == ""
        return stick.report.turn >= end

    until(pushed)


def column(stick: RemoteDevice, name: str) -> int:
    return [channel.name for channel in (*TRIAL_ROW, *stick.row_channels)].index(name)


def test_the_hand_and_the_field_reach_the_stick(stick: RemoteDevice) -> None:
    drive(stick, 1, 500)
    state = stick.advance(GRIP)
    values = dict(zip((c.name for c in stick.channels), stick.values(), strict=True))
    assert state.position[0] > 0.005
    assert state.position[1] < -0.002
    assert state.position[2] > 0.1
    assert values["stick_state"] == 2
    stick.close_trial()


def test_every_tick_of_the_firmware_is_a_row(stick: RemoteDevice) -> None:
    ring = Ring(stick.files.rows)
    ring.take(ring.written)
    drive(stick, 2, 400)
    rows = stick.close_trial()
    data = ring.read().data
    assert len(data) == rows >= 400
    assert set(data[:, column(stick, "trial")]) == {2.0}
    np.testing.assert_array_equal(data[:, column(stick, "row")], np.arange(rows))
    ticks = data[:, column(stick, "stick_tick")]
    np.testing.assert_array_equal(np.diff(ticks), 1.0)
    assert np.all(np.diff(data[:, column(stick, "heard_at")]) >= 0.0)


def test_a_trial_s_measures_add_up(stick: RemoteDevice) -> None:
    drive(stick, 3, 300)
    rows = stick.close_trial()
    told = {measure.name: measure.value for measure in stick.measures(3)}
    assert told["device_turns"] >= 300
    assert told["device_ticks"] == rows
    assert told["dropped_frames"] == told["damaged_frames"] == 0
    assert 0.0 <= told["turn_lateness_p50"] <= told["turn_lateness_p99"]
    assert told["saturated_stick_x"] == 0.0


def test_between_trials_it_stays_awake_without_force(stick: RemoteDevice) -> None:
    drive(stick, 4, 100)
    stick.close_trial()
    end = stick.report.turn + 600  # twice as long as the firmware bears silence
    until(lambda: stick.report.turn >= end)
    assert stick.trouble() == ""
    assert stick.report.values[column(stick, "stick_state") - column(stick, "motor_x")] == 2


def test_a_device_that_cannot_be_reached_says_why(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    with pytest.raises(NotReached, match="avr-gcc"):
        RemoteDevice(EmulatedStickDevice())


def test_a_dead_process_is_noticed(toolchain: None) -> None:
    with RemoteDevice(EmulatedStickDevice()) as remote:
        drive(remote, 1, 50)
        os.kill(remote.process_id, signal.SIGKILL)
        until(remote.trouble)
        assert "ended with exit code -9" in remote.trouble()


def test_a_stuck_process_is_noticed(toolchain: None) -> None:
    with RemoteDevice(EmulatedStickDevice()) as remote:
        drive(remote, 1, 50)
        os.kill(remote.process_id, signal.SIGSTOP)
        until(remote.trouble)
        assert "said nothing" in remote.trouble()
        os.kill(remote.process_id, signal.SIGCONT)


SIMULATION = """
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.remote_device import RemoteDevice
from test_remote_device import drive
import sys, time
if __name__ == "__main__":
    remote = RemoteDevice(EmulatedStickDevice())
    drive(remote, 1, 300)
    print(remote.files.folder, len(remote.channels), flush=True)
    drive(remote, 1, 10**9)
"""


@pytest.mark.slow
def test_a_dead_simulation_lets_the_stick_go_soft(toolchain: None, tmp_path: Path) -> None:
    script = tmp_path / "simulation.py"
    script.write_text(SIMULATION)
    environment = os.environ | {
        "PYTHONPATH": os.pathsep.join([*sys.path, str(Path(__file__).parent)])
    }
    simulation = subprocess.Popen(
        [sys.executable, str(script)], env=environment, stdout=subprocess.PIPE, text=True
    )
    assert simulation.stdout is not None
    folder, values = simulation.stdout.readline().split()
    reports = LatestValue(Files(Path(folder)).reports)
    layout = ReportLayout(3, int(values))

    def motors() -> tuple[float, ...]:
        latest = reports.read()
        assert latest is not None
        return layout.unpack(latest.data).values[:3]

    assert abs(motors()[0]) > 0.5
    simulation.kill()
    simulation.wait()
    until(lambda: motors() == (0.0, 0.0, 0.0))
    until(lambda: not Path(folder).exists())
    simulation.stdout.close()
