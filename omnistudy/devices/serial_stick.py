"""The 3-DOF stick with our firmware on a serial port."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Literal

from omnistudy.channel import Measure
from omnistudy.devices.device import Device, Identity, RunningDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.ceiling import NO_CEILING, Ceiling
from omnistudy.devices.stick.force_calibration import ForceCalibration
from omnistudy.devices.stick.passivity import AddedDamping


class SerialStickDevice(Device):
    """A real stick, or `device emulate`'s; its settings are those in its own memory."""

    in_lockstep: ClassVar[bool] = False
    apart: ClassVar[bool] = True

    kind: Literal["serial_stick"] = "serial_stick"
    port: str = ""
    """Such as /dev/ttyACM0; the only one that is attached unless given."""
    stick: SimulatedStick = SimulatedStick()
    """Counts, stops and force at full duty: what counts and PWM steps mean at the handle."""
    ceiling: Ceiling = NO_CEILING
    """Greatest force of anything together, centring too; the firmware's own limit."""
    added_damping: AddedDamping | None = None
    """Against energy that the stick gives out; none unless given, the energy is recorded anyway."""
    calibration: ForceCalibration | None = None
    """What its forces were found to be with `device calibrate --force`; nominal unless given."""

    def before_force(
        self, tell: Callable[[str], None], expected: Identity | None = None
    ) -> tuple[Measure, ...]:
        """Lead through the checks at the port; raises ChecksFailed and what port and line raise."""
        from omnistudy.devices.stick.before_force import checked
        from omnistudy.devices.stick.serial_port import SerialPort, only_port

        return checked(SerialPort(self.port or only_port()), self.stick, tell, expected)

    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the stick; its port is opened and it is armed when it is first used."""
        from omnistudy.devices.serial_stick_in_motion import SerialStickInMotion

        return SerialStickInMotion(self)
