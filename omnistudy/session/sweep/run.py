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
from omnistudy.trial import TrialSpec, run_trial

LOOK_EVERY_S = 0.5
"""How often the folder is asked what is finished."""

LOADING_S = 3.0
"""A first trial shorter than this is timed again, for it mostly loads the physics."""


@dataclass(frozen=True, slots=True)
class Remaining:
    """What a run has before it.

    places : of the sweep's listed points, 0-based; a search lists none. points : how many are left.
    seconds_a_trial : on one worker.
    """

    places: tuple[int, ...]
    points: int
    trials_a_point: int
    seconds_a_trial: float

    @property
    def trials(self) -> int:
        """Count the trials that are to be driven."""
        return self.points * self.trials_a_point

    def seconds(self, workers: int) -> float:
        """Give the expected wall time in s."""
        return self.trials * self.seconds_a_trial / workers


def remaining(folder: SweepFolder, sweep: Sweep) -> Remaining:
    """Say what is left, timed by what was driven or, before anything was, by one trial."""
    done = folder.done()
    places = tuple(
        index
        for index, point in enumerate(sweep.points)
        if (point.design, point.nuisance) not in done
    )
    points = len(places)
    if sweep.search is not None:
        places, points = (), sweep.designs * sweep.nuisances - len(done)
    finished = folder.finished()
    if finished:
        seconds = fmean(point.seconds for point in finished) / len(sweep.trials)
    else:
        seconds = timed_trial(sweep)
    return Remaining(places, points, len(sweep.trials), seconds)


def timed_trial(sweep: Sweep) -> float:
    """Drive one trial and say in s how long it took; 0 when it fails at every point.

    That a point fails is not told here: its job does that.
    """
    for point in sweep.points:
        try:
            spec = spec_of(changed(sweep.base, point.changes), sweep.trials[0])
            took = _timed(spec)
        except Exception:
            continue
        return _timed(spec) if took < LOADING_S else took
    return 0.0


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
    folder.forget_errors()
    jobs = cut(left.places, launcher, workers, left.seconds_a_trial * left.trials_a_point)
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


def _timed(spec: TrialSpec) -> float:
    began = time.perf_counter()
    run_trial(spec)
    return time.perf_counter() - began
