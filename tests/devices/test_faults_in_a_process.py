"""Faults of a stick that a process of its own turns: told, soft, and no row is lost.

In what time they are told is asserted in the board's own time, in test_stick_faults.py.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from faulty_stick import FaultyStick

from omnistudy.channel import Ring
from omnistudy.channel.trial_row import TRIAL_ROW
from omnistudy.devices import Hand
from omnistudy.devices.remote_device import RemoteDevice
from omnistudy.geometry import ForceField, PlanarWrench

pytestmark = [pytest.mark.usefixtures("toolchain"), pytest.mark.slow]

GRIP = Hand((0.01, -0.008, 0.3), (400.0, 400.0, 20.0), (20.0, 20.0, 0.5), (0.8, 0.8, 0.003))


def until(happened: Callable[[], object]) -> None:
    end = time.monotonic() + 60.0
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.005)


@pytest.mark.parametrize(
    ("fault", "told"),
    [
        ("unplug", "nothing was heard"),
        ("brown_out", "started anew \\(a brown-out\\)"),
        ("slow_telemetry", "of its telemetry came"),
        ("other_stick", "another stick was plugged in"),
        ("frozen_encoder", "encoder of x stands still"),
        ("estop", "ESTOP"),
    ],
)
def test_a_fault_is_told_the_stick_soft_and_every_row_kept(
    tmp_path: Path, fault: str, told: str
) -> None:
    control = tmp_path / "fault"
    with RemoteDevice(FaultyStick(control=control)) as stick:
        stick.open_trial(1)
        turn = [0]

        def driven() -> bool:
            turn[0] += 1
            push = 4.0 if turn[0] // 40 % 2 else -4.0
            stick.render(ForceField(PlanarWrench(push, 0.0, 0.0), valid_for=0.25))
            stick.advance(GRIP)
            return stick.report.turn > 400

        until(driven)
        assert stick.trouble() == ""
        (tmp_path / "part").write_text(fault)
        (tmp_path / "part").rename(control)
        until(lambda: driven() and stick.trouble())
        assert re.search(told, stick.trouble())
        assert stick.advance(GRIP).position == (0.0, 0.0, 0.0)
        names = [channel.name for channel in (*TRIAL_ROW, *stick.row_channels)]
        rows = Ring(stick.files.rows).read().data
        ticks = rows[:, names.index("stick_tick")][:300]
        assert (rows[:, 0] == 1).all()
        assert (np.diff(ticks) == 1).all()
    assert control.with_suffix(".duties").read_text() == "0 0 0 0 0 0\n"
