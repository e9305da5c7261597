"""How long the participant's screen takes to show what is simulated."""

from __future__ import annotations

from collections import deque
from statistics import median

from omnistudy.view.answer import Lag

KEPT = 36_000
"""Frames of ten minutes."""


class ScreenLag:
    """Collects when each frame of one trial was drawn, by the session's clock."""

    def __init__(self) -> None:
        self._trial = 0
        self._ms: deque[float] = deque(maxlen=KEPT)
        self._frames = 0
        self._clock_ms = 0.0

    def drew(self, trial: int, made: float, at: float, within: float) -> None:
        """Take a frame: the state made at `made` s was on the screen at `at` s.

        within : s by which `at` may be wrong, as the page knows the session's clock only so well.
        """
        if trial != self._trial:
            self._trial, self._frames, self._clock_ms = trial, 0, 0.0
            self._ms.clear()
        self._ms.append(1000.0 * (at - made))
        self._frames += 1
        self._clock_ms = max(self._clock_ms, 1000.0 * within)

    def lag(self) -> Lag:
        """Sum up the trial's frames so far, of which there must be one."""
        ordered = sorted(self._ms)
        p99 = ordered[min(len(ordered) - 1, round(0.99 * len(ordered)))]
        return Lag(
            trial=self._trial,
            frames=self._frames,
            median_ms=median(ordered),
            p99_ms=p99,
            clock_ms=self._clock_ms,
        )
