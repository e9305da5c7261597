"""What a 3Dconnexion SpaceMouse sends, as six numbers."""

from __future__ import annotations

from struct import Struct
from typing import NamedTuple

from omnistudy.devices.handheld.axes import HardwareAxis

TRANSLATION, ROTATION = 1, 2
"""Numbers of the reports (first byte); 3 are the buttons, others battery and lights."""
THREE = Struct("<3h")
SIX = Struct("<6h")
"""Newer models tell all six in report 1."""
FULL = 350.0
"""Number at the end of the cap's travel, either way."""
NAMES = ("right", "back", "down", "pitch", "roll", "clockwise")
"""The sense in which each number rises: x to the right, y to the user, z down; turns about these.

`pitch` is about x and `roll` about y, both right-handed; seen from above, about z is clockwise.
"""
SPACE_MOUSE_AXES = tuple(HardwareAxis(name, -FULL, 0.0, FULL) for name in NAMES)


class CapState(NamedTuple):
    """Where the cap was last said to be; numbers as in `NAMES`."""

    translation: tuple[float, ...] = (0.0, 0.0, 0.0)
    rotation: tuple[float, ...] = (0.0, 0.0, 0.0)

    def after(self, report: bytes) -> CapState:
        """Give the state once a report has come; what is no report of the cap changes nothing."""
        number, body = report[:1], report[1:]
        if number == bytes((TRANSLATION,)) and len(body) >= SIX.size:
            told = SIX.unpack_from(body)
            return CapState(_floats(told[:3]), _floats(told[3:]))
        if number == bytes((TRANSLATION,)) and len(body) >= THREE.size:
            return self._replace(translation=_floats(THREE.unpack_from(body)))
        if number == bytes((ROTATION,)) and len(body) >= THREE.size:
            return self._replace(rotation=_floats(THREE.unpack_from(body)))
        return self


def _floats(told: tuple[int, ...]) -> tuple[float, ...]:
    return tuple(float(value) for value in told)
