"""No stick at all: the hand's reference is what the controller gets."""

from __future__ import annotations

from typing import Literal

from omnistudy.channel import Channel
from omnistudy.devices.device import Device, DeviceState, Hand, RunningDevice
from omnistudy.geometry import ForceField


class DirectDevice(Device):
    """Passes a logged twist (m/s, m/s, rad/s) on; it can render no force."""

    kind: Literal["direct"] = "direct"

    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the device with zero command."""
        return _RunningDirect()


class _RunningDirect(RunningDevice):
    forces = (False, False, False)
    axes = (
        Channel("stick_x", "m/s", "commanded forward velocity"),
        Channel("stick_y", "m/s", "commanded leftward velocity"),
        Channel("stick_theta", "rad/s", "commanded turning rate"),
    )

    def render(self, field: ForceField) -> None:
        """Feel nothing: there is no motor."""

    def advance(self, hand: Hand) -> DeviceState:
        """Give the hand's reference."""
        return DeviceState(hand.reference, (0.0, 0.0, 0.0))
