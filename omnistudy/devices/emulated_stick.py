"""The thesis's 3-DOF stick with its real firmware, on an emulated processor in lockstep."""

from __future__ import annotations

from typing import Literal

from omnistudy.devices.device import Device, RunningDevice
from omnistudy.devices.simulated_stick import SimulatedStick


class EmulatedStickDevice(Device):
    """The firmware in the loop: each instruction is run, the mechanism moves 20 000 times a second.

    Needs avr-gcc and libsimavr-dev; about five times faster than real time.
    """

    kind: Literal["emulated_stick"] = "emulated_stick"
    stick: SimulatedStick = SimulatedStick()
    """Mechanism, centring and limits as the simulated stick has them; but the firmware ticks at
    1 kHz and drives one pin of a pair at a time, whatever the stick's own settings for that say."""

    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the stick at rest in its centre; the board is powered up when it is first used."""
        from omnistudy.devices.emulated_stick_in_motion import EmulatedStickInMotion

        return EmulatedStickInMotion(self, physics_hz)
