"""The thesis's 3-DOF stick with its real firmware, on an emulated processor in lockstep."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Literal

from omnistudy.channel import Measure
from omnistudy.devices.device import Device, Identity, RunningDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.ceiling import NO_CEILING, Ceiling
from omnistudy.devices.stick.force_calibration import ForceCalibration
from omnistudy.devices.stick.passivity import AddedDamping

ATTENDED = "The emulated stick is checked; an emulated attendant does what is asked:"


class EmulatedStickDevice(Device):
    """The firmware in the loop: each instruction is run, the mechanism moves 20 000 times a second.

    Needs avr-gcc and libsimavr-dev; about five times faster than real time.
    """

    apart: ClassVar[bool] = True

    kind: Literal["emulated_stick"] = "emulated_stick"
    stick: SimulatedStick = SimulatedStick()
    """Mechanism, centring and limits as the simulated stick has them; but the firmware ticks at
    1 kHz and drives one pin of a pair at a time, whatever the stick's own settings for that say."""
    ceiling: Ceiling = NO_CEILING
    """Greatest force of anything together, centring too; the firmware's own limit."""
    added_damping: AddedDamping | None = None
    """Against energy that the stick gives out; none unless given, the energy is recorded anyway."""
    calibration: ForceCalibration | None = None
    """What its forces were found to be with `device calibrate --force`; nominal unless given."""

    def before_force(
        self, tell: Callable[[str], None], expected: Identity | None = None
    ) -> tuple[Measure, ...]:
        """Check a board of its own that an attendant is at; raises ChecksFailed."""
        from omnistudy.devices.stick.attendant import Attendant
        from omnistudy.devices.stick.before_force import checked
        from omnistudy.devices.stick.emulator import EmulatedStick, mechanisms

        board = EmulatedStick(mechanisms(self.stick))
        board.release()
        attendant = Attendant(board)
        tell(ATTENDED)

        def told(sentence: str) -> None:
            tell(sentence)
            attendant(sentence)

        return checked(board, self.stick, told, expected)

    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the stick at rest in its centre; the board is powered up when it is first used."""
        from omnistudy.devices.emulated_stick_in_motion import EmulatedStickInMotion

        return EmulatedStickInMotion(self, physics_hz)
