"""`omnistudy device calibrate --force`: from a file of readings, and at a stick on load cells."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.conversion import handle_scale
from omnistudy.devices.stick.emulator import EmulatedStick
from omnistudy.devices.stick.pseudo_terminal import PseudoTerminal
from omnistudy.devices.stick.toolchain import missing_packages
from omnistudy.session.parts import part

OMNISTUDY = (sys.executable, "-c", "from omnistudy.cli.app import main; main()")
AXES = ("x", "y", "theta")


def calibrate(
    lab: Path, device: str, *options: str, typed: str = ""
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*OMNISTUDY, "device", "calibrate", device, "--force", *options],
        capture_output=True, text=True, timeout=60, input=typed,
        env={**os.environ, "OMNISTUDY_CONF": str(lab)},
    )  # fmt: skip


@pytest.fixture
def readings(tmp_path: Path) -> Path:
    """Give readings of 0.05 N, 0.04 N and 0.005 N·m a step beyond 10 PWM."""
    rows = [
        f"{axis},{duty},{slope * (duty - 10 * ((duty > 0) - (duty < 0))):.6f}"
        for axis, slope in zip(AXES, (0.05, 0.04, 0.005), strict=True)
        for duty in (0, 50, -50, 100, -100, 200, -200, 0)
    ]
    file = tmp_path / "readings.csv"
    file.write_text("\n".join(("axis,duty,force", *rows)))
    return file


@pytest.mark.slow
def test_readings_become_a_page_that_a_stick_is_driven_by(
    tmp_path: Path, readings: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ran = calibrate(
        tmp_path, "serial_stick", "--readings", str(readings), "--page", "ours",
        "--instrument", "spring scale", "--who", "ab",
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    device = part("device", "ours", tmp_path)
    assert device.kind == "serial_stick"
    assert device.calibration.instrument == "spring scale"
    assert device.calibration.who == "ab"
    assert device.calibration.name in ran.stdout
    scale = handle_scale(SimulatedStick(), device.calibration)
    assert scale.per_duty == pytest.approx((0.05, 0.04, 0.005))
    assert scale.dead_band == pytest.approx((10, 10, 10), rel=1e-3)


@pytest.mark.slow
def test_a_page_is_shown_and_not_written_or_asked_for_before_it_is_replaced(
    tmp_path: Path, readings: Path
) -> None:
    given = ("--readings", str(readings), "--instrument", "scale")
    ran = calibrate(tmp_path, "emulated_stick", *given, "--dry-run", "--json")
    page = yaml.safe_load(json.loads(ran.stdout)["page"])
    assert page["kind"] == "emulated_stick"
    assert not (tmp_path / "device").exists()
    (tmp_path / "device").mkdir()
    (tmp_path / "device" / "emulated_stick.yaml").write_text("kind: emulated_stick\n")
    assert calibrate(tmp_path, "emulated_stick", *given, typed="n\n").returncode == 1
    kept = (tmp_path / "device" / "emulated_stick.yaml").read_text()
    assert kept == "kind: emulated_stick\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("device", "options", "code", "said"),
    [
        ("serial_stick", (), 2, "--instrument says what was read"),
        ("gamepad", ("--instrument", "scale"), 1, "pushes along no axis"),
        ("emulated_stick", ("--instrument", "scale"), 1, "at no serial port"),
    ],
)
def test_what_is_missing_is_one_sentence(
    tmp_path: Path, device: str, options: tuple[str, ...], code: int, said: str
) -> None:
    ran = calibrate(tmp_path, device, *options)
    assert ran.returncode == code
    assert said in ran.stderr
    assert "Traceback" not in ran.stderr


@pytest.mark.slow
@pytest.mark.parametrize(
    ("line", "said"),
    [("x,50", "no reading"), ("z,50,1.0", "axis 'z'"), ("x,5.5,1.0", "duty '5.5'")],
)
def test_a_broken_reading_is_told_with_its_line(
    tmp_path: Path, readings: Path, line: str, said: str
) -> None:
    rows = readings.read_text().splitlines()
    readings.write_text("\n".join((*rows[:3], line, *rows[3:])))
    ran = calibrate(tmp_path, "serial_stick", "--readings", str(readings), "--instrument", "scale")
    assert ran.returncode == 1
    assert "line 4" in ran.stderr
    assert said in ran.stderr


@pytest.fixture
def stick_on_cells() -> Iterator[tuple[EmulatedStick, str]]:
    missing = missing_packages()
    if missing:
        pytest.skip(f"needs {', '.join(missing)}: `make system-packages`")
    board = EmulatedStick()
    board.press_estop(False)
    board.hold_dead_man(True)
    for axis in range(3):
        board.clamp(axis)
    board.release()
    terminal = PseudoTerminal(board)
    over = threading.Event()
    pacing = threading.Thread(target=terminal.keep_pace, args=(over.is_set,))
    pacing.start()
    yield board, terminal.path
    over.set()
    pacing.join()
    terminal.close()
    board.close()


@pytest.mark.slow
def test_whoever_reads_the_instrument_is_led_through_every_step(
    tmp_path: Path, stick_on_cells: tuple[EmulatedStick, str]
) -> None:
    board, port = stick_on_cells
    leading = subprocess.Popen(
        [*OMNISTUDY, "device", "calibrate", port, "--force", "--levels", "2", "--page", "ours",
         "--instrument", "load cells"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "OMNISTUDY_CONF": str(tmp_path)},
    )  # fmt: skip
    assert leading.stdin is not None
    assert leading.stderr is not None
    asked = 0
    for said in leading.stderr:
        if said.startswith("Fix the handle"):
            print(file=leading.stdin, flush=True)
        elif wanted := re.match(r"\d+ of 30: (x|y|theta), ", said):
            asked += 1
            reading = board.cell_force(AXES.index(wanted[1]))
            print(f"{reading:.3f}", file=leading.stdin, flush=True)
        else:
            pytest.fail(said)
    assert leading.wait() == 0
    assert asked == 30
    for stream in (leading.stdin, leading.stdout, leading.stderr):
        assert stream is not None
        stream.close()
    calibration = part("device", "ours", tmp_path).calibration
    assert calibration.serial == "0"
    truth = handle_scale(SimulatedStick()).per_duty
    assert [one.per_duty for one in calibration.axes] == pytest.approx(truth, rel=0.02)
    assert len((tmp_path / "device" / "ours.csv").read_text().splitlines()) == 31
