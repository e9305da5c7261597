"""A study that is driven live with the emulated stick, as tests of the live runtime use it."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import RunSummary, run_trials
from omnistudy.session.held_devices import HeldDevices
from omnistudy.session.live import RealTime, run_live
from omnistudy.store import StoredTrial
from omnistudy.study import create_study
from omnistudy.trial import Glimpse, TrialResult, TrialSpec

PARTS = (
    "world=primitive_c",
    "routes=[through]",
    "participants.count=1",
    "order.block_length=1",
    "device=emulated_stick",
)
FOUR_SECONDS = "task.time_limit=0.35"
"""Of the route's length at top speed: who drives longer is timed out."""


def until(happened: Callable[[], object]) -> None:
    """Wait for something that must happen, however busy the machine is."""
    end = time.monotonic() + 60.0
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.005)


class Meddler(RealTime):
    """Keeps a trial's pace, and does something once it has run for a while."""

    def __init__(self, after: float, meddle: Callable[[], None]) -> None:
        super().__init__()
        self._after = after
        self._meddle = meddle
        self.meddled = False

    def see(self, glimpse: Glimpse) -> None:
        if glimpse.t >= self._after and not self.meddled:
            self.meddled = True
            self._meddle()

    def end(self, status: str) -> None:
        """Hear it, and do nothing."""

    @property
    def stopped(self) -> bool:
        return False


def nothing() -> None:
    """Meddle with nothing."""


def make_study(path: Path, *overrides: str) -> Path:
    create_study(compose_protocol("utah2017_component", (*PARTS, *overrides)), path, path.stem)
    return path


def drive(
    study: Path,
    trials: int = 1,
    meddle: Callable[[HeldDevices], None] = lambda devices: None,
    after: float = 1.0,
) -> RunSummary:
    """Run trials live; `meddle` happens once, in the first attempt."""
    companions: list[Meddler] = []
    with HeldDevices(study) as devices:

        def accompany(trial: StoredTrial) -> RealTime:
            first = not companions
            companions.append(Meddler(after, (lambda: meddle(devices)) if first else nothing))
            return companions[-1]

        def run(ready: Sequence[StoredTrial], specs: Iterator[TrialSpec]) -> Iterator[TrialResult]:
            return run_live(ready, specs, accompany, devices)

        return run_trials(study, limit=trials, run=run)


if __name__ == "__main__":
    drive(Path(sys.argv[1]))
