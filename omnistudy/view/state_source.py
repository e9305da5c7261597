"""The states of a running session, from sessions that come and go."""

from __future__ import annotations

import time
from pathlib import Path

from omnistudy.channel import LatestValue
from omnistudy.channel.latest import Value

LOOK_S = 0.5
"""How often it is looked whether another session has begun."""


class StateSource:
    """Maps the file of the session that runs now; None while there is none."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self._mapped: LatestValue | None = None
        self._which = 0
        self._looked = 0.0

    def latest(self) -> Value | None:
        """Give the latest state."""
        now = time.monotonic()
        if now - self._looked > LOOK_S:
            self._looked = now
            self._follow()
        return self._mapped.read() if self._mapped else None

    def close(self) -> None:
        """Let go of the file."""
        if self._mapped:
            self._mapped.close()
            self._mapped = None

    def _follow(self) -> None:
        try:
            which = self._file.stat().st_ino
            if self._mapped and which == self._which:
                return
            self.close()
            self._mapped, self._which = LatestValue(self._file), which
        except (FileNotFoundError, ValueError):  # no session, or one that is just beginning
            self.close()
