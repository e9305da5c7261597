"""A session asks a device for its checks before force, and stores what they find."""

from __future__ import annotations

import pytest
from faulty_stick import FaultyLine
from stick_bench import Bench

from omnistudy.devices import Identity
from omnistudy.devices.direct import DirectDevice
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.attendant import Attendant
from omnistudy.devices.stick.before_force import DRIFTED, checked
from omnistudy.devices.stick.checks import LET_GO, PRESS_STOP
from omnistudy.errors.stick_checks import ChecksFailed


@pytest.mark.slow
@pytest.mark.usefixtures("toolchain")
def test_the_emulated_stick_is_led_through_its_checks() -> None:
    told: list[str] = []
    device = EmulatedStickDevice()
    measures = {one.name: one for one in device.before_force(told.append)}
    assert PRESS_STOP in told
    assert LET_GO in told
    assert measures["check_sign_of_theta"].value == 1.0
    assert measures["zero_shift_y"] == ("zero_shift_y", 0.0, "count")


@pytest.mark.usefixtures("toolchain")
def test_another_stick_than_before_is_refused() -> None:
    before = Identity("emulated_stick", serial="3", firmware="0000abcd")
    with pytest.raises(ChecksFailed, match="instead of 3, 0000abcd"):
        EmulatedStickDevice().before_force(lambda sentence: None, before)


def test_a_device_without_force_has_nothing_to_check() -> None:
    assert DirectDevice().before_force(pytest.fail) == ()


@pytest.mark.slow
@pytest.mark.usefixtures("toolchain")
def test_a_zero_that_drifted_is_told_when_something_was_driven(bench: Bench) -> None:
    bench.board.release()
    for _ in range(8):
        bench.board.jump(0)
        bench.board.run(0.1)
    who = bench.line.identify()
    before = Identity("serial_stick", str(who.serial), f"{who.firmware:08x}")
    told: list[str] = []
    attendant = Attendant(bench.board)

    def tell(sentence: str) -> None:
        told.append(sentence)
        attendant(sentence)

    wire = FaultyLine(bench.board)
    measures = checked(wire, SimulatedStick(), tell, before)
    assert wire.last_duties == (0,) * 6  # closed, and soft
    assert told[-1] == DRIFTED
    assert abs({one.name: one.value for one in measures}["zero_shift_x"]) == 16
