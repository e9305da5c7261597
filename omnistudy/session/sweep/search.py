"""Design points asked for one after the other: Optuna's ask and tell, kept as any other points."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from functools import partial
from importlib.util import find_spec
from math import isfinite
from multiprocessing import get_context
from statistics import fmean
from typing import TYPE_CHECKING, Any

from omnistudy.errors.session import WorkerDied
from omnistudy.errors.sweep import ObjectiveNotRecorded, OptunaNotInstalled
from omnistudy.seeds import seed_text
from omnistudy.session.sweep.folder import Finished, SweepFolder
from omnistudy.session.sweep.job import run_points
from omnistudy.session.sweep.planning import SweepPlan
from omnistudy.session.sweep.points import rounded
from omnistudy.session.sweep.question import Point, Search
from omnistudy.session.sweep.run import tell_failures
from omnistudy.session.sweep.variables import Interval, Swept

if TYPE_CHECKING:
    from optuna.distributions import BaseDistribution

RunPoints = Callable[[list[Point]], None]


def require_optuna() -> None:
    """Raise OptunaNotInstalled unless it is there."""
    if find_spec("optuna") is None:
        raise OptunaNotInstalled


def run_search(
    folder: SweepFolder,
    plan: SweepPlan,
    search: Search,
    workers: int,
    finished: Callable[[int], None] = lambda points: None,
) -> None:
    """Ask for design points, drive each over the whole nuisance, tell the mean of the objective.

    The sampler is seeded, so a search that was stopped asks for the same points again: those that
    were driven are told from the folder, and it goes on after them. A failed point is told as such.
    finished : told how many more points are over.

    Raises ObjectiveNotRecorded, WorkerDied, and JobsFailed at the end.
    """
    import optuna

    optuna.logging.set_verbosity(optuna.logging.ERROR)
    folder.forget_errors()
    seed = int(seed_text(plan.sweep.seed, "optuna")[:8], 16)
    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=seed))
    chosen = [one for one in plan.asked.swept if one.variable.role == "design"]
    distributions = {one.variable.key: _distribution(one) for one in chosen}
    with _workers(folder, plan, workers) as run:
        for design in range(1, search.samples + 1):
            trial = study.ask(distributions)
            values = {one.variable.key: _value(one, trial.params) for one in chosen}
            points = _points(plan, values, design)
            waiting = _not_driven(folder, points)
            run(waiting)
            finished(len(waiting))
            told = _objective(folder, points, search.objective)
            if told is None:
                study.tell(trial, state=optuna.trial.TrialState.FAIL)
            else:
                study.tell(trial, told)
    tell_failures(folder)


def _distribution(one: Swept) -> BaseDistribution:
    """Numbers of a list are searched in their order, words without one."""
    from optuna.distributions import (
        CategoricalDistribution,
        FloatDistribution,
        IntDistribution,
    )

    values = one.values
    if isinstance(values, Interval):
        if values.whole:
            return IntDistribution(int(values.low), int(values.high))
        return FloatDistribution(values.low, values.high)
    if all(isinstance(value, int | float) for value in values):
        return IntDistribution(0, len(values) - 1)
    return CategoricalDistribution(list(range(len(values))))


def _value(one: Swept, asked: dict[str, Any]) -> Any:
    given = asked[one.variable.key]
    if isinstance(one.values, Interval):
        return given if one.values.whole else rounded(given, one.values)
    return one.values[given]


def _points(plan: SweepPlan, values: dict[str, Any], design: int) -> list[Point]:
    """Cross a design point with the nuisance."""
    keys = plan.sweep.keys("nuisance")
    return [
        plan.points.at(
            {**values, **dict(zip(keys, point.values, strict=True))}, design, point.nuisance
        )
        for point in plan.sweep.points
    ]


def _not_driven(folder: SweepFolder, points: list[Point]) -> list[Point]:
    """Drop what was driven; after a failed point was mended others are asked for than before."""
    waiting = []
    for point in points:
        kept = folder.kept(point.design, point.nuisance)
        if kept is not None and kept.values == point.values:
            continue
        folder.drop(point.design, point.nuisance)
        waiting.append(point)
    return waiting


def _objective(folder: SweepFolder, points: list[Point], column: str) -> float | None:
    """Give the mean over all trials of a design point; None when one of its points failed."""
    kept = [folder.kept(point.design, point.nuisance) for point in points]
    driven: list[Finished] = [one for one in kept if one is not None]
    if len(driven) < len(points):
        return None
    told = fmean(row[column] for one in driven for row in one.rows)
    if not isfinite(told):
        raise ObjectiveNotRecorded(column)
    return told


@contextmanager
def _workers(folder: SweepFolder, plan: SweepPlan, workers: int) -> Iterator[RunPoints]:
    """Give what drives points on as many processes; one: in this process."""
    drive = partial(run_points, folder, plan.sweep)
    if workers <= 1:
        yield drive
        return
    with ProcessPoolExecutor(
        workers,
        mp_context=get_context("spawn"),
        # Ctrl-C reaches workers too: they end at once, instead of reporting it and going on.
        initializer=signal.signal,
        initargs=(signal.SIGINT, signal.SIG_DFL),
    ) as pool:
        try:
            yield lambda points: list(pool.map(drive, [[point] for point in points])).clear()
        except BrokenProcessPool as cause:
            raise WorkerDied from cause
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
