"""A serial port onto the emulated board whose time passes only while the port is read."""

from __future__ import annotations

from omnistudy.devices.stick.pseudo_terminal import PseudoTerminal
from omnistudy.devices.stick.serial_port import SerialPort


class CarriedPort(SerialPort):
    """A serial port whose other end is carried a little whenever this one is read."""

    def __init__(self, terminal: PseudoTerminal) -> None:
        super().__init__(terminal.path)
        self._terminal = terminal

    def read(self, seconds: float) -> bytes:
        self._terminal.carry(0.001)
        return super().read(0.0)

    def now(self) -> float:
        return self._terminal.board.now()
