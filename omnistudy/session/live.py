"""Trials at the pace of the clock on the wall."""

from __future__ import annotations

import signal
import threading
import time
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace

from omnistudy.channel import Channel, Event, Measure, measured
from omnistudy.session.held_devices import HeldDevices
from omnistudy.store import StoredTrial
from omnistudy.trial import TrialResult, TrialSpec, run_trial
from omnistudy.trial.companion import Companion


class RealTime(Companion):
    """Lets no step begin before its time; a late step is late, not longer.

    late : steps so far that began after the next one should have.
    interrupted : set to end the trial before its next step, and the session with it.
    """

    def __init__(self) -> None:
        self.late = 0
        self.interrupted = False
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
            early = self._opened + t - time.monotonic()
        if -early > step > 0.0:
            self.late += 1
        return not (self.interrupted or self.stopped)

    def remarks(self) -> tuple[tuple[str, str], ...]:
        """Tell how many steps were late."""
        return (("pace", f"{self.late} late steps"),)

    def measures(self) -> tuple[Measure, ...]:
        """Tell how well the pace was kept."""
        return (measured("late_steps", self.late),)

    @property
    @abstractmethod
    def stopped(self) -> bool:
        """Whether somebody wants the trial to end now."""


Accompany = Callable[[StoredTrial], RealTime]


def run_live(
    trials: Iterable[StoredTrial],
    specs: Iterable[TrialSpec],
    accompany: Accompany,
    devices: HeldDevices,
    before: Callable[[StoredTrial], None] = lambda trial: None,
) -> Iterator[TrialResult]:
    """Run trials one after the other in this process, each with its companion and its device.

    What companion and devices remark is stored as events at the trial's end. Ctrl-C aborts the
    trial, which is given whole; what asks for the next one then gets KeyboardInterrupt.

    before : called ahead of each trial, which is not begun while it lasts: what it raises leaves
        the trial planned.
    """
    waiting = iter(specs)
    for trial in trials:
        before(trial)
        spec = next(waiting)
        companion = accompany(trial)
        held = devices.take(spec.device, spec.recording.physics_hz)
        devices.open_trial(trial.id)
        with _ended_by_ctrl_c(companion), devices.undisturbed():
            result = run_trial(spec, companion, held)
        served = devices.close_trial(trial.id, ailed=result.status == "void")
        end = float(result.samples[-1, 0])
        remarks = (*companion.remarks(), *devices.remarks())
        yield replace(
            result,
            events=(*result.events, *(Event(end, kind, detail) for kind, detail in remarks)),
            measures=(*companion.measures(), *served),
        )
        if companion.interrupted:
            raise KeyboardInterrupt


@contextmanager
def _ended_by_ctrl_c(companion: RealTime) -> Iterator[None]:
    """Let Ctrl-C end the trial at its next step, with all that was recorded; a second one at once.

    Where signals cannot be caught, outside the main thread, nothing changes.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(*_: object) -> None:
        signal.signal(signal.SIGINT, before)
        companion.interrupted = True

    before = signal.signal(signal.SIGINT, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
