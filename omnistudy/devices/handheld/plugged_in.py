"""What can be driven with here and now."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import NamedTuple

from omnistudy.devices.handheld.choice import Attached
from omnistudy.errors.handheld import CannotOpen, NoDriver


class PluggedIn(NamedTuple):
    """What was found; `unseen` says in a sentence each which kinds could not be looked for."""

    attached: tuple[Attached, ...]
    unseen: tuple[str, ...]


def plugged_in() -> PluggedIn:
    """Look for every kind of device that is plugged in; opens none for driving."""
    attached: list[Attached] = []
    unseen = []
    for look in _looks():
        try:
            attached += look()
        except (NoDriver, CannotOpen) as reason:
            unseen.append(str(reason))
    return PluggedIn(tuple(attached), tuple(unseen))


def _looks() -> tuple[Callable[[], tuple[Attached, ...]], ...]:
    from omnistudy.devices.handheld.sdl_hardware import attached_sdl_sticks
    from omnistudy.devices.handheld.space_mouse_hardware import attached_space_mice

    if sys.platform != "linux":
        return attached_sdl_sticks, attached_space_mice
    from omnistudy.devices.handheld.evdev_hardware import attached_force_sticks

    return _attached_serial_sticks, attached_force_sticks, attached_sdl_sticks, attached_space_mice


def _attached_serial_sticks() -> tuple[Attached, ...]:
    from omnistudy.devices.stick.serial_port import attached_ports

    return tuple(Attached("serial_stick", "serial port", "", port) for port in attached_ports())
