"""Which of the plugged-in devices a page means."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from omnistudy.errors.handheld import NothingPluggedIn, WhichDevice


class Attached(NamedTuple):
    """A device that is plugged in.

    kind : kind of device that drives with it. path : where its driver finds it.
    """

    kind: str
    name: str
    serial: str
    path: str

    def told(self) -> str:
        """Name it in a sentence."""
        return f"'{self.name}'" + (f" (serial number {self.serial})" if self.serial else "")


def the_one(device: str, there: Sequence[Attached], name: str, serial: str) -> Attached:
    """Give the device that a page means; raises NothingPluggedIn or WhichDevice.

    name : part of its name, in any case. serial : its serial number. Empty fits any.
    """
    fitting = [
        one
        for one in there
        if name.casefold() in one.name.casefold() and serial in ("", one.serial)
    ]
    if not fitting:
        asked = [f"name '{name}'"] * bool(name) + [f"serial number {serial}"] * bool(serial)
        raise NothingPluggedIn(device, " and ".join(asked), [one.told() for one in there])
    if len(fitting) > 1:
        raise WhichDevice(device, [one.told() for one in fitting])
    return fitting[0]
