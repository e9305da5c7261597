"""What the page's server says about held keys, made into levers that move out and back."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pydantic import BaseModel, ConfigDict, ValidationError

from omnistudy.channel import LatestValue
from omnistudy.devices.device import Identity
from omnistudy.devices.handheld.axes import HardwareAxis
from omnistudy.devices.handheld.hardware import Hardware

if TYPE_CHECKING:
    from omnistudy.devices.handheld.keyboard import Keyboard


LOOK_S = 0.5
"""s between two looks whether a page has begun, or another one (ours)."""


class KeysHeld(BaseModel):
    """Keys held at a time of this machine's monotonic clock, s."""

    model_config = ConfigDict(frozen=True)

    at: float
    held: tuple[str, ...] = ()


class HeldKeys(Hardware):
    """One lever a key, 0 at rest to 1.

    The file need not be there yet: until the page has begun, nothing is held.
    """

    def __init__(
        self,
        file: Path,
        names: Sequence[str],
        keyboard: Keyboard,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.axes = tuple(HardwareAxis(name, 0.0, 0.0, 1.0) for name in names)
        self._file = file
        self._keyboard = keyboard
        self._clock = clock
        self._mapped: LatestValue | None = None
        self._which = 0
        self._look_at = 0.0
        self._levers = [0.0] * len(names)
        self._now = clock()

    def read(self) -> tuple[float, ...]:
        """Move each lever by the time that has passed."""
        before, self._now = self._now, self._clock()
        passed = self._now - before
        held = self._held()
        for index, (name, *_) in enumerate(self.axes):
            lever = self._levers[index]
            if name in held:
                self._levers[index] = min(1.0, lever + passed / self._keyboard.out_in)
            else:
                self._levers[index] = max(0.0, lever - passed / self._keyboard.back_in)
        return tuple(self._levers)

    def trouble(self) -> str:
        """Nothing ails it: keys that nobody renews are released keys."""
        return ""

    def identity(self) -> Identity:
        """Browsers do not tell which keyboard it is."""
        return Identity("keyboard")

    def close(self) -> None:
        """Let go of the file."""
        if self._mapped is not None:
            self._mapped.close()
            self._mapped = None

    def _held(self) -> tuple[str, ...]:
        value = self._latest()
        if value is None:
            return ()
        try:
            told = KeysHeld.model_validate_json(value)
        except ValidationError:
            return ()  # another version's server: a hand that is not understood holds nothing
        fresh = self._now - told.at <= self._keyboard.stale_after
        return told.held if fresh else ()

    def _latest(self) -> bytes | None:
        if self._now >= self._look_at:
            self._look_at = self._now + LOOK_S
            self._follow()
        value = self._mapped.read() if self._mapped else None
        return value.data if value else None

    def _follow(self) -> None:
        """Map the file that is there now, which a new page's server makes anew."""
        try:
            which = self._file.stat().st_ino
            if self._mapped and which == self._which:
                return
            self.close()
            self._mapped, self._which = LatestValue(self._file), which
        except (FileNotFoundError, ValueError):
            self.close()  # no page has begun
