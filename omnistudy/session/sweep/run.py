"""Running a sweep: what is left of it, how long that takes, and the jobs that do it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import fmean
from threading import Event, Thread

from omnistudy.errors.sweep import JobsFailed
from omnistudy.session.sweep.driven import spec_of
from omnistudy.session.sweep.effects import changed
from omnistudy.session.sweep.folder import SweepFolder
from omnistudy.session.sweep.launch import launch
from omnistudy.session.sweep.launchers import Launcher, cut, settings
from omnistudy.session.sweep.question import Sweep
from omnistudy.trial import run_trial

LOOK_EVERY_S = 0.5
"""How often the folder is asked what is finished."""

LOADING_S = 3.0
"""A first trial shorter than this is timed again, for it mostly loads the physics."""


@dataclass(frozen=True, slots=True)
class Remaining:
    """What a run has before it.

    points : 0-based places in the sweep's list. seconds_a_trial : on one worker.
    """

    points: tuple[int, ...]
    trials_a_point: int
    seconds_a_trial: float

    @property
    def trials(self) -> int:
        """How many trials are to be driven."""
        return len(self.points) * self.trials_a_point

    def seconds(self, workers: int) -> float:
        """Give the expected wall time in s."""
        return self.trials * self.seconds_a_trial / workers


def remaining(folder: SweepFolder, sweep: Sweep) -> Remaining:
    """Say what is left, timed by what was driven or, before anything was, by one trial."""
    done = folder.done()
    points = tuple(
        index
        for index, point in enumerate(sweep.points)
        if (point.design, point.nuisance) not in done
    )
    if not points:
        return Remaining((), len(sweep.trials), 0.0)
    finished = folder.finished()
    if finished:
        seconds = fmean(point.seconds for point in finished) / len(sweep.trials)
    else:
        seconds = timed_trial(sweep, points[0])
    return Remaining(points, len(sweep.trials), seconds)


def timed_trial(sweep: Sweep, point: int) -> float:
    """Drive the first trial of a point and say in s how long it took."""
    spec = spec_of(changed(sweep.base, sweep.points[point].changes), sweep.trials[0])
    took = _timed(lambda: run_trial(spec))
    return _timed(lambda: run_trial(spec)) if took < LOADING_S else took


def run_sweep(
    folder: SweepFolder,
    sweep: Sweep,
    left: Remaining,
    launcher: Launcher,
    workers: int,
    *,
    own_settings: Sequence[str] = (),
    ray_address: str | None = None,
    finished: Callable[[int], None] = lambda points: None,
) -> None:
    """Drive what is left; a stop loses only the points that were being driven.

    own_settings : of Hydra's launcher. finished : told how many more points are over.

    Raises LauncherFailed, and JobsFailed at the end.
    """
    for file in folder.failures.glob("*.json"):
        file.unlink()
    jobs = cut(left.points, launcher, workers, left.seconds_a_trial * left.trials_a_point)
    if jobs:
        chosen = settings(launcher, workers, left.seconds(1), ray_address)
        with _watching(folder, finished):
            launch(folder.path, jobs, launcher, (*chosen, *own_settings))
    tell_failures(folder)


def tell_failures(folder: SweepFolder) -> None:
    """Raise JobsFailed when a point failed."""
    errors = folder.errors()
    if errors:
        raise JobsFailed(folder.name, len(errors), errors[0].error, folder.failures)


@contextmanager
def _watching(folder: SweepFolder, finished: Callable[[int], None]) -> Iterator[None]:
    """Tell what other processes finish, by what stands in the folder."""
    over = Event()
    told = len(folder.done())

    def look() -> None:
        nonlocal told
        now = len(folder.done() | folder.failed())
        if now > told:
            finished(now - told)
            told = now

    def watch() -> None:
        while not over.wait(LOOK_EVERY_S):
            look()

    watcher = Thread(target=watch, daemon=True)
    watcher.start()
    try:
        yield
    finally:
        over.set()
        watcher.join()
        look()


def _timed(work: Callable[[], object]) -> float:
    began = time.perf_counter()
    work()
    return time.perf_counter() - began
