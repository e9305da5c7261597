"""A SpaceMouse through hidapi."""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

from omnistudy.devices.device import Identity
from omnistudy.devices.handheld.choice import Attached, the_one
from omnistudy.devices.handheld.hardware import Hardware
from omnistudy.devices.handheld.space_mouse_reports import SPACE_MOUSE_AXES, CapState
from omnistudy.errors.handheld import CannotOpen, NoDriver

LOGITECH = 0x046D
"""Under this maker's number came the older models, 0xC6nn (0xC603 to 0xC62B)."""
CONNEXION = 0x256F
"""3Dconnexion's own maker's number."""
MULTI_AXIS = (0x01, 0x08)
"""Usage page and usage of a multi-axis controller, which a receiver's other parts are not."""
LONGEST = 64
"""Bytes of the longest report."""


def attached_space_mice() -> tuple[Attached, ...]:
    """List the space mice that are plugged in; raises NoDriver."""
    return tuple(
        Attached(
            "space_mouse",
            one["product_string"] or "SpaceMouse",
            one["serial_number"] or "",
            one["path"].decode(),
        )
        for one in _hidapi().enumerate()
        if _is_space_mouse(one)
    )


def open_space_mouse(name: str, serial: str) -> SpaceMouseHardware:
    """Open the mouse that is meant; raises NoDriver, NothingPluggedIn, WhichDevice, CannotOpen."""
    hidapi = _hidapi()
    chosen = the_one("space_mouse", attached_space_mice(), name, serial)
    device = hidapi.device()
    try:
        device.open_path(chosen.path.encode())
    except OSError as cause:
        remedy = f"allow your user to read and write {chosen.path} (a udev rule; docs/how-to)"
        raise CannotOpen("space_mouse", chosen.told(), str(cause), remedy) from cause
    device.set_nonblocking(True)
    return SpaceMouseHardware(device, chosen)


class SpaceMouseHardware(Hardware):
    """Reports, every one of which is taken in at each `read`: none is left to be late."""

    axes = SPACE_MOUSE_AXES

    def __init__(self, device: Any, attached: Attached) -> None:
        self._device = device
        self._attached = attached
        self._cap = CapState()
        self._lost = False

    def read(self) -> tuple[float, ...]:
        """Take in all reports."""
        try:
            while not self._lost and (report := self._device.read(LONGEST)):
                self._cap = self._cap.after(bytes(report))
        except OSError:
            self._lost = True
        return (*self._cap.translation, *self._cap.rotation)

    def trouble(self) -> str:
        """Tell whether it was unplugged."""
        return f"{self._attached.told()} was unplugged" if self._lost else ""

    def identity(self) -> Identity:
        """Tell its name and serial number."""
        return Identity(self._attached.name, self._attached.serial)

    def close(self) -> None:
        """Let go of it."""
        self._device.close()


def _hidapi() -> Any:
    """Give hidapi; on Linux the one that asks the kernel, which leaves its drivers in place."""
    try:
        return import_module("hidraw" if sys.platform == "linux" else "hid")
    except ImportError as cause:
        remedy = "pip install 'omnistudy[devices]'"
        raise NoDriver("space_mouse", "the Python package hidapi", remedy) from cause


def _is_space_mouse(one: dict[str, Any]) -> bool:
    vendor, product = one["vendor_id"], one["product_id"]
    ours = vendor == CONNEXION or (vendor == LOGITECH and 0xC603 <= product <= 0xC62B)
    usage = (one["usage_page"], one["usage"])
    return ours and usage in (MULTI_AXIS, (0, 0))
