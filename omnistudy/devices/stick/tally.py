"""What a stick's telemetry tells of the line and the motors, counted."""

from __future__ import annotations

from collections.abc import Sequence

from omnistudy.devices.device import Health
from omnistudy.devices.stick.messages import Telemetry, Three

TICKS = 1 << 32
"""The device's count of ticks begins again here."""
LONGEST_GAP = 10_000
"""Ticks; a greater step is no loss on the line but another beginning: the device was reset."""


class Tally:
    """Counts ticks heard, missed by their numbers, and those at which a motor was at its limit."""

    def __init__(self, limits: Three) -> None:
        """Begin to count; limits in PWM steps are what each motor gets at most."""
        self._limits = limits
        self._ticks = 0
        self._missed = 0
        self._saturated = [0, 0, 0]
        self._last: int | None = None

    def take(self, heard: Sequence[Telemetry]) -> None:
        """Count what was heard, oldest first."""
        for told in heard:
            self._ticks += 1
            if self._last is not None:
                gap = (told.tick - self._last) % TICKS - 1
                if 0 < gap < LONGEST_GAP:
                    self._missed += gap
            self._last = told.tick
            for axis, duty in enumerate(told.motor):
                if not -self._limits[axis] < duty < self._limits[axis]:
                    self._saturated[axis] += 1

    def health(self, damaged: int) -> Health:
        """Give the counts; `damaged` frames are the deframer's."""
        return Health(self._ticks, self._missed, damaged, tuple(self._saturated))
