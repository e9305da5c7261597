"""Gamepads, twist sticks and other joysticks that SDL2 knows."""

from __future__ import annotations

from typing import Literal

from omnistudy.devices.handheld.axes import AxisMap
from omnistudy.devices.handheld.force_effects import Strength
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.handheld.hardware import Hardware


class SdlStick(Handheld):
    """A gamepad or joystick through SDL2; force in x and y where it has motors for it.

    As a gamepad its axes have names, whatever the make: left_x, left_y, right_x, right_y,
    left_trigger, right_trigger, and buttons such as a, b, leftshoulder. As a joystick they are
    counted: axis_0, hat_0_x, button_0.
    """

    kind: Literal["sdl_stick"] = "sdl_stick"
    read_as: Literal["gamepad", "joystick"] = "joystick"
    """gamepad: axes are named by what they are; SDL must know the make. joystick: by number."""
    x: AxisMap = AxisMap(axis="axis_1", sign=-1, dead_zone=0.05)
    y: AxisMap = AxisMap(axis="axis_0", sign=-1, dead_zone=0.05)
    theta: AxisMap = AxisMap(axis="axis_2", sign=-1, dead_zone=0.05)
    """Axis 2 is RZ, the twist, of sticks without a throttle before it."""
    strength: Strength | None = None
    """How strong its motors are; without it they push nothing. Rumble is no force."""

    @property
    def rendered(self) -> Strength | None:
        """How strong its motors are."""
        return self.strength

    def reach(self) -> Hardware:
        """Open it; raises NoDriver, NothingPluggedIn, WhichDevice, CannotOpen."""
        from omnistudy.devices.handheld.sdl_hardware import open_sdl_stick

        return open_sdl_stick(self)
