"""Trials at the pace of the clock on the wall."""

from __future__ import annotations

import time
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from omnistudy.channel import Channel, Event
from omnistudy.store import StoredTrial
from omnistudy.trial import TrialResult, TrialSpec, run_trial
from omnistudy.trial.companion import Companion


class RealTime(Companion):
    """Lets no step begin before its time; a late step is late, not longer.

    late : steps so far that began after the next one should have.
    """

    def __init__(self) -> None:
        self.late = 0
        self._opened = 0.0
        self._last_step = 0.0

    def begin(self, plant: tuple[Channel, ...], axes: tuple[Channel, ...]) -> None:
        """Start the clock."""
        self.late = 0
        self._last_step = 0.0
        self._opened = time.monotonic()

    def goes_on(self, t: float) -> bool:
        """Sleep until it is time."""
        step, self._last_step = t - self._last_step, t
        early = self._opened + t - time.monotonic()
        if early > 0.0:
            time.sleep(early)
        elif -early > step > 0.0:
            self.late += 1
        return not self.stopped

    def remarks(self) -> tuple[tuple[str, str], ...]:
        """Tell how many steps were late."""
        return (("pace", f"{self.late} late steps"),)

    @property
    @abstractmethod
    def stopped(self) -> bool:
        """Whether somebody wants the trial to end now."""


Accompany = Callable[[StoredTrial], RealTime]


def run_live(
    trials: Iterable[StoredTrial],
    specs: Iterable[TrialSpec],
    accompany: Accompany,
    before: Callable[[StoredTrial], None] = lambda trial: None,
) -> Iterator[TrialResult]:
    """Run trials one after the other in this process, each with its companion.

    What the companion remarks is stored as events at the trial's end.
    before : called ahead of each trial, which is not begun while it lasts: what it raises leaves
        the trial planned.
    """
    waiting = iter(specs)
    for trial in trials:
        before(trial)
        spec = next(waiting)
        companion = accompany(trial)
        result = run_trial(spec, companion)
        end = float(result.samples[-1, 0])
        remarks = (Event(end, kind, detail) for kind, detail in companion.remarks())
        yield replace(result, events=(*result.events, *remarks))
