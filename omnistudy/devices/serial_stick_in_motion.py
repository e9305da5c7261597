"""The stick on a serial port during one trial: what came is taken, nothing is waited for."""

from __future__ import annotations

from omnistudy.devices.device import DeviceState, Hand
from omnistudy.devices.serial_stick import SerialStickDevice
from omnistudy.devices.stick.check import wait_for_telemetry
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Configuration
from omnistudy.devices.stick.serial_port import SerialPort, only_port
from omnistudy.devices.stick.transport import Transport
from omnistudy.devices.stick_on_line import StickOnLine
from omnistudy.errors.devices import PortLost


class SerialStickInMotion(StickOnLine):
    """Opens and arms at its first use, which takes up to four seconds; then it never waits."""

    def __init__(self, device: SerialStickDevice) -> None:
        super().__init__(
            device.kind, device.stick, device.ceiling, device.added_damping, device.calibration
        )
        self._port = device.port

    def _open(self) -> Transport:
        return SerialPort(self._port or only_port())

    def _settings(self, line: StickLine) -> Configuration:
        wait_for_telemetry(line)
        return line.configuration()

    def advance(self, hand: Hand) -> DeviceState:
        """Give what the newest telemetry says; whoever holds the stick is no concern of ours."""
        line = self._reach()
        if line is None:
            return self._out_of_reach()
        try:
            heard = line.drain()
        except PortLost as cause:
            self._ail(cause)
            heard = []
        return self._hear(line, heard)
