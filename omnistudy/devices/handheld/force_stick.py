"""A force-feedback stick that Linux has a driver for."""

from __future__ import annotations

from typing import Literal

from omnistudy.devices.handheld.axes import AxisMap
from omnistudy.devices.handheld.force_effects import Strength
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.handheld.hardware import Hardware


class ForceStick(Handheld):
    """A force-feedback stick through Linux's event devices: force in x and y, none on the twist.

    Axes and buttons have Linux's names, such as ABS_X, ABS_RZ, BTN_TRIGGER. The stick renders
    spring and damper itself, along each axis; dead zone and exponent would bend them, so that
    there is none unless given. Linux only.
    """

    kind: Literal["force_stick"] = "force_stick"
    x: AxisMap = AxisMap(axis="ABS_Y", sign=-1)
    y: AxisMap = AxisMap(axis="ABS_X", sign=-1)
    theta: AxisMap = AxisMap(axis="ABS_RZ", sign=-1, dead_zone=0.1)
    strength: Strength = Strength()

    @property
    def rendered(self) -> Strength | None:
        """How strong its motors are."""
        return self.strength

    def reach(self) -> Hardware:
        """Open it; raises NoDriver, NothingPluggedIn, WhichDevice, CannotOpen."""
        from omnistudy.devices.handheld.evdev_hardware import open_force_stick

        return open_force_stick(self)
