"""A SpaceMouse: a cap that is pushed and turned, without force."""

from __future__ import annotations

from typing import Literal

from omnistudy.devices.handheld.axes import AxisMap
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.handheld.hardware import Hardware


class SpaceMouse(Handheld):
    """A 3Dconnexion SpaceMouse through hidapi; no force.

    Axes: right, back, down, pitch, roll, clockwise. Its numbers are read without 3Dconnexion's own
    driver, which must not run beside.
    """

    kind: Literal["space_mouse"] = "space_mouse"
    x: AxisMap = AxisMap(axis="back", sign=-1, dead_zone=0.05)
    y: AxisMap = AxisMap(axis="right", sign=-1, dead_zone=0.05)
    theta: AxisMap = AxisMap(axis="clockwise", sign=-1, dead_zone=0.05)

    def reach(self) -> Hardware:
        """Open the mouse; raises NoDriver, NothingPluggedIn, WhichDevice, CannotOpen."""
        from omnistudy.devices.handheld.space_mouse_hardware import open_space_mouse

        return open_space_mouse(self.name, self.serial)
