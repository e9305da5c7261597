"""Which device a verb of `omnistudy device` was given: a serial port or a page."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from omnistudy.devices.handheld.handheld import Handheld
    from omnistudy.devices.stick.line import StickLine


def chosen_port(given: str | None) -> str | None:
    """Give the serial port that was meant, "" for the only one; None for any other device."""
    if given is None:
        return ""
    if "/" in given:
        return given
    from omnistudy.devices.serial_stick import SerialStickDevice
    from omnistudy.session.parts import part

    device = part("device", given)
    return device.port if isinstance(device, SerialStickDevice) else None


def hardware_of(given: str | None, verb: str) -> Handheld:
    """Give the bought device of a page; raises UnknownPart, BrokenPart, NoSuchDevice."""
    from omnistudy.devices.handheld.handheld import Handheld
    from omnistudy.errors.handheld import NoSuchDevice
    from omnistudy.session.parts import part

    device = part("device", given or "")
    if not isinstance(device, Handheld):
        raise NoSuchDevice(device.kind, verb)
    return device


def is_bought(given: str) -> bool:
    """Tell whether a page is that of a gamepad, a bought stick or the like; raises UnknownPart."""
    from omnistudy.devices.handheld.handheld import Handheld
    from omnistudy.session.parts import part

    return "/" not in given and isinstance(part("device", given), Handheld)


@contextmanager
def stick_line(port: str) -> Iterator[StickLine]:
    """Open the line to a stick with our firmware; "" is the only port there is."""
    from omnistudy.devices.stick.line import StickLine
    from omnistudy.devices.stick.serial_port import SerialPort, only_port

    transport = SerialPort(port or only_port())
    try:
        yield StickLine(transport)
    finally:
        transport.close()
