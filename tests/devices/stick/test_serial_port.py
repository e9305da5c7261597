"""The serial line in wall time, against the emulated board behind a pseudo-terminal.

The board's time is emulated and passes only while the port is read, so nothing waits.
"""

from __future__ import annotations

import fcntl
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from carried_port import CarriedPort
from stick_bench import Bench

from omnistudy.devices.stick.check import check_stick
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import State
from omnistudy.devices.stick.pseudo_terminal import PseudoTerminal
from omnistudy.devices.stick.serial_port import SerialPort
from omnistudy.errors.devices import NoAnswer, NoPort, NoTelemetry, PortLost

TIOCGEXCL = 0x80045440


@pytest.fixture
def terminal(bench: Bench) -> Iterator[PseudoTerminal]:
    made = PseudoTerminal(bench.board)
    yield made
    made.close()


def test_a_stick_is_checked_and_armed_through_its_port(terminal: PseudoTerminal) -> None:
    port = CarriedPort(terminal)
    line = StickLine(port)
    findings = {one.what: one for one in check_stick(line)}
    assert [what for what, one in findings.items() if not one.sound] == ["settings"]
    assert findings["telemetry"].found.endswith(" 0 lost")
    line.arm()
    assert line.listen(0.01)[-1].state == State.RISING
    port.close()


def test_a_port_is_nobody_else_s_while_it_is_open(terminal: PseudoTerminal) -> None:
    port = SerialPort(terminal.path)
    # Asked of the kernel, for root may open it all the same.
    exclusive = fcntl.ioctl(port._file, TIOCGEXCL, bytes(4))
    assert exclusive == (1).to_bytes(4, sys.byteorder)
    port.close()


def test_what_is_no_port_is_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(NoPort, match="No such file"):
        SerialPort(str(tmp_path / "ttyACM0"))
    (tmp_path / "file").touch()
    with pytest.raises(NoPort, match="no serial port"):
        SerialPort(str(tmp_path / "file"))


def test_an_unplugged_stick_is_noticed(bench: Bench) -> None:
    terminal = PseudoTerminal(bench.board)
    port = SerialPort(terminal.path)
    terminal.close()
    with pytest.raises(PortLost, match="unplugged"):
        port.read(0.0)
    port.close()


class Mute:
    """A line at which nobody is."""

    def __init__(self) -> None:
        self.time = 0.0

    def write(self, data: bytes) -> None:
        pass

    def read(self, seconds: float) -> bytes:
        self.time += seconds
        return b""

    def now(self) -> float:
        return self.time

    def close(self) -> None:
        pass


def test_a_mute_line_is_not_waited_for_for_ever() -> None:
    with pytest.raises(NoTelemetry):
        check_stick(StickLine(Mute()))
    with pytest.raises(NoAnswer, match="did not answer 'hello' within 1 s"):
        StickLine(Mute()).identify()


def test_a_port_that_takes_nothing_stops_nobody(bench: Bench) -> None:
    terminal = PseudoTerminal(bench.board)
    port = SerialPort(terminal.path)
    with pytest.raises(PortLost):
        port.write(bytes(1 << 20))  # more than any terminal holds, and nobody carries it on
    port.close()
    terminal.close()
