"""A device with six axes that follows the hand exactly and renders nothing."""

from __future__ import annotations

from typing import Literal

from omnistudy.channel import Channel
from omnistudy.devices import Device, DeviceState, Hand, RunningDevice
from omnistudy.geometry import ForceField


class SixAxes(Device):
    """Three pushes and three twists."""

    kind: Literal["six_axes"] = "six_axes"

    def connect(self, physics_hz: int) -> RunningDevice:
        return _RunningSixAxes()


class _RunningSixAxes(RunningDevice):
    axes = (
        *(Channel(f"push_{axis}", "m", f"push along {axis}") for axis in "xyz"),
        *(Channel(f"twist_{axis}", "rad", f"twist about {axis}") for axis in "xyz"),
    )

    def render(self, field: ForceField) -> None:
        """There is no motor."""

    def advance(self, hand: Hand) -> DeviceState:
        return DeviceState(hand.reference, (0.0,) * 6)
