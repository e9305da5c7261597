"""The statistics that the thesis reports, each computed from one group's paired trials.

Best and worst participant: the lowest and highest mean over all trials with and without feedback
(ours; the thesis does not say how they were picked). NaN when the trials needed are missing.
"""

from __future__ import annotations

from collections.abc import Callable
from math import nan

import numpy as np

from omnistudy.analysis.pairs import Grid, Pairs
from omnistudy.analysis.sign_flip import sign_flip

TRIALS = 3
"""Trials with, and trials without feedback of each person in the thesis (sec. 4.5)."""

Statistic = Callable[[Pairs, str], float]
"""A group's paired trials and a seed text in, one number out."""


def mean(values: Grid) -> float:
    """Give the mean of the finite values; NaN without one."""
    finite = values[np.isfinite(values)]
    return float(finite.mean()) if finite.size else nan


def _row_means(values: Grid) -> Grid:
    return np.array([mean(row) for row in values], dtype=np.float64)


def _most(values: Grid) -> float:
    """Give the largest of a person's values; NaN below TRIALS of them, for that would be lower."""
    return _largest(values) if np.isfinite(values).sum() >= TRIALS else nan


def _most_later(values: Grid) -> float:
    return _largest(values[1:]) if np.isfinite(values).sum() >= TRIALS else nan


def _largest(values: Grid) -> float:
    finite = values[np.isfinite(values)]
    return float(finite.max()) if finite.size else nan


def _trial(values: Grid, number: int) -> Grid:
    """Give the column of one repetition (1-based); empty below TRIALS columns.

    The one trial a quantile of the arm-stiffness study is a first one by number alone.
    """
    return values[..., number - 1 : number] if values.shape[-1] >= TRIALS else values[..., :0]


def _ratio(above: float, below: float) -> float:
    return above / below if below > 0 else nan


def _share_zero_by_third(values: Grid) -> float:
    third = _trial(values, 3)
    finite = third[np.isfinite(third)]
    return float((finite == 0).mean()) if finite.size else nan


def _ranked(pairs: Pairs, worst: bool) -> int | None:
    means = _row_means(np.hstack([pairs.with_collisions, pairs.without_collisions]))
    if not np.isfinite(means).any():
        return None
    return int(np.nanargmax(means) if worst else np.nanargmin(means))


def best_participant(pairs: Pairs) -> str | None:
    """Name the participant with the fewest collisions a trial; the first of equals."""
    row = _ranked(pairs, worst=False)
    return None if row is None else pairs.participants[row]


def worst_participant(pairs: Pairs) -> str | None:
    """Name the participant with the most collisions a trial; the first of equals."""
    row = _ranked(pairs, worst=True)
    return None if row is None else pairs.participants[row]


def _of_person(worst: bool, with_feedback: bool, value: Callable[[Grid], float]) -> Statistic:
    def statistic(pairs: Pairs, seed: str) -> float:
        row = _ranked(pairs, worst)
        if row is None:
            return nan
        grid = pairs.with_collisions if with_feedback else pairs.without_collisions
        return value(grid[row])

    return statistic


def _first(values: Grid) -> float:
    return mean(_trial(values, 1))


def _third(values: Grid) -> float:
    return mean(_trial(values, 3))


def _p_collisions(pairs: Pairs, seed: str) -> float:
    return sign_flip(_differences(pairs.with_collisions, pairs.without_collisions), seed).p


def _p_time(pairs: Pairs, seed: str) -> float:
    return sign_flip(_differences(pairs.with_times, pairs.without_times), seed).p


def _differences(with_feedback: Grid, without: Grid) -> Grid:
    return _row_means(with_feedback) - _row_means(without)


STATISTICS: dict[str, Statistic] = {
    "mean_without": lambda pairs, seed: mean(pairs.without_collisions),
    "mean_with": lambda pairs, seed: mean(pairs.with_collisions),
    "third_without": lambda pairs, seed: _third(pairs.without_collisions),
    "share_zero_with": lambda pairs, seed: _share_zero_by_third(pairs.with_collisions),
    "learning_with": lambda pairs, seed: _ratio(
        _third(pairs.with_collisions), _first(pairs.with_collisions)
    ),
    "learning_without": lambda pairs, seed: _ratio(
        _third(pairs.without_collisions), _first(pairs.without_collisions)
    ),
    "p_collisions": _p_collisions,
    "time_ratio": lambda pairs, seed: _ratio(mean(pairs.with_times), mean(pairs.without_times)),
    "p_time": _p_time,
    "best_without_mean": _of_person(worst=False, with_feedback=False, value=mean),
    "best_without_max": _of_person(worst=False, with_feedback=False, value=_most),
    "best_without_last": _of_person(worst=False, with_feedback=False, value=_third),
    "best_with_max": _of_person(worst=False, with_feedback=True, value=_most),
    "best_with_later": _of_person(worst=False, with_feedback=True, value=_most_later),
    "worst_without_mean": _of_person(worst=True, with_feedback=False, value=mean),
    "worst_without_first": _of_person(worst=True, with_feedback=False, value=_first),
    "worst_without_last": _of_person(worst=True, with_feedback=False, value=_third),
    "worst_with_mean": _of_person(worst=True, with_feedback=True, value=mean),
    "worst_with_first": _of_person(worst=True, with_feedback=True, value=_first),
    "worst_with_last": _of_person(worst=True, with_feedback=True, value=_third),
}
"""One statistic for each key of `published_utah2017.CLAIMS`."""
