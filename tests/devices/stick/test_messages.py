"""The generated files follow their description."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from omnistudy.devices.stick import layouts, messages

ROOT = Path(__file__).resolve().parents[3]


def test_generated_files_are_fresh() -> None:
    made = subprocess.run(
        [sys.executable, ROOT / "firmware" / "protocol" / "make.py", "--check"],
        capture_output=True,
        text=True,
    )
    assert (made.returncode, made.stdout) == (0, ""), "run `make -C firmware protocol`"


def test_default_configuration_is_the_thesis_firmware_in_wire_steps() -> None:
    default = layouts.DEFAULT_CONFIGURATION
    # 0.7 PWM/degree of the motor is 0.175 PWM a count (1440 counts a turn), times 1024.
    assert default.centring_stiffness[:2] == (179, 179)
    # 42 PWM·ms/degree is 10.5 PWM·ms a count, times 32.
    assert default.centring_damping[:2] == (336, 336)
    assert [value / 256 for value in default.counts_per_degree] == [12.0, 15.0, 4.0]


def test_telemetry_of_every_tick_fits_the_line() -> None:
    frame = layouts.LAYOUTS[messages.Telemetry].size + 4 + 2
    assert frame * messages.TICK_HZ * 10 <= messages.BAUD
