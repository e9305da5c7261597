"""Which design point of a sweep is best, how sure that is, and what is not dominated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, sqrt
from typing import Literal, NamedTuple

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.stats import t as student

from omnistudy.analysis.estimate import UNKNOWN, Interval
from omnistudy.errors.sweep import NoCompletePoint, ObjectiveNotRecorded, UnknownOutcome
from omnistudy.seeds import generator

Statistic = Literal["mean", "worst_tenth"]

OUTCOMES = {
    "collisions": "collisions a trial",
    "duration_s": "time, s",
    "work_against_j": "work against the hand, J",
}
"""Column of the table -> what it is; all three are wanted small."""

GROUPS = 2000
"""Groups of participants drawn for an interval."""
CONFIDENCE = 0.95
ROUNDING = 1e-12
"""Relative spread below which numbers are the same."""
WORST = 0.1
"""Part of the nuisance points that counts as the worst."""


class Spread(NamedTuple):
    """A number with its interval; NaN, NaN when participants show no spread."""

    value: float
    interval: Interval


@dataclass(frozen=True, slots=True)
class DesignPoint:
    """One combination of the design variables.

    row : its number, which stays when more points are finished. values : in the order of the keys.
    outcomes : mean over nuisance and participants by column of OUTCOMES, NaN where not recorded.
    mean, worst_tenth : of the column that ranks. behind : how far its mean (its worst tenth) is
        behind that of the best row, paired. tied : the two cannot be told apart.
    timed_out : share of its trials that ran out of time; they count with what they had by then.
    in_front : no other row is at least as good in every outcome and better in one.
    """

    row: int
    values: tuple[object, ...]
    outcomes: dict[str, float]
    mean: Spread
    worst_tenth: Spread
    behind: Spread
    tied: bool
    timed_out: float
    in_front: bool


@dataclass(frozen=True, slots=True)
class Ranking:
    """A sweep's design points, the best first.

    by : column; order : statistic that sorts. left_out : rows that are not driven over all of the
    nuisance yet.
    """

    by: str
    order: Statistic
    keys: tuple[str, ...]
    points: tuple[DesignPoint, ...]
    left_out: tuple[int, ...]
    participants: int
    nuisance_points: int
    trials: int
    method: str


def rank(
    table: pd.DataFrame,
    keys: Sequence[str],
    nuisance_points: int,
    seed: str,
    *,
    by: str = "collisions",
    order: Statistic = "mean",
) -> Ranking:
    """Rank the design points of a table with one row a trial.

    table : columns design, nuisance, participant, status, the keys and OUTCOMES.
    keys : design variables. nuisance_points : how many each design point has to meet.
    by : column of OUTCOMES that ranks.

    Raises UnknownOutcome, NoCompletePoint, ObjectiveNotRecorded.
    """
    if by not in OUTCOMES:
        raise UnknownOutcome(by, list(OUTCOMES))
    complete, left_out = _complete(table, nuisance_points)
    if complete.empty:
        raise NoCompletePoint(nuisance_points)
    rows = tuple(int(row) for row in sorted(complete["design"].unique()))
    cells = {name: cell_means(complete, rows, name) for name in OUTCOMES}
    if not np.isfinite(cells[by]).all():
        raise ObjectiveNotRecorded(by)
    points = _points(complete, rows, keys, cells, cells[by], order, seed)
    return Ranking(
        by=by,
        order=order,
        keys=tuple(keys),
        points=tuple(sorted(points, key=lambda point: (getattr(point, order).value, point.row))),
        left_out=left_out,
        participants=cells[by].shape[2],
        nuisance_points=nuisance_points,
        trials=len(complete),
        method=_method(len(rows) - 1),
    )


def _points(
    table: pd.DataFrame,
    rows: Sequence[int],
    keys: Sequence[str],
    cells: dict[str, NDArray[np.float64]],
    ranked: NDArray[np.float64],
    order: Statistic,
    seed: str,
) -> list[DesignPoint]:
    weights = _drawn_groups(ranked.shape[2], seed)
    best = int(np.argmin(_statistic(ranked, order)))
    means = {name: column.mean(axis=(1, 2)) for name, column in cells.items()}
    front = not_dominated(np.column_stack([*means.values()]))
    values = _values(table, keys)
    late = table["status"].eq("timed_out").groupby(table["design"]).mean()
    points = []
    for place, row in enumerate(rows):
        behind = _behind(ranked[place], ranked[best], weights, order, max(len(rows) - 1, 1))
        points.append(
            DesignPoint(
                row=row,
                values=values[row],
                outcomes={name: float(column[place]) for name, column in means.items()},
                mean=_spread(ranked[place], weights, "mean"),
                worst_tenth=_spread(ranked[place], weights, "worst_tenth"),
                behind=behind,
                tied=place == best or not behind.interval.low > 0.0,
                timed_out=float(late[row]),
                in_front=bool(front[place]),
            )
        )
    return points


def cell_means(table: pd.DataFrame, rows: Sequence[int], column: str) -> NDArray[np.float64]:
    """Give means over a participant's trials: (design rows, nuisance points, participants)."""
    means = table.pivot_table(
        index="design", columns=["nuisance", "participant"], values=column, dropna=False
    ).reindex(list(rows))
    nuisances = table["nuisance"].nunique()
    return means.to_numpy(dtype=np.float64).reshape(len(rows), nuisances, -1)


def not_dominated(outcomes: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which rows (n, outcomes) no other row beats or equals everywhere; small is good.

    Columns with a NaN are left out.
    """
    known = outcomes[:, np.isfinite(outcomes).all(axis=0)]
    front = np.ones(len(known), dtype=np.bool_)
    for place, row in enumerate(known):
        as_good = (known <= row).all(axis=1)
        better = (known < row).any(axis=1)
        front[place] = not (as_good & better).any()
    return front


def worst_tenth(cells: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the mean of the largest tenth (at least one) along the first axis."""
    count = ceil(WORST * len(cells))
    worst: NDArray[np.float64] = np.sort(cells, axis=0)[-count:].mean(axis=0)
    return worst


def _complete(table: pd.DataFrame, nuisance_points: int) -> tuple[pd.DataFrame, tuple[int, ...]]:
    """Keep design points that met all of the nuisance: others were compared on easier ground."""
    met = table.groupby("design")["nuisance"].nunique()
    whole = met.index[met.eq(nuisance_points)]
    left_out = tuple(int(row) for row in met.index.difference(whole))
    return table[table["design"].isin(whole)], left_out


def _values(table: pd.DataFrame, keys: Sequence[str]) -> dict[int, tuple[object, ...]]:
    firsts = table.drop_duplicates("design")[["design", *keys]]
    return {int(row): tuple(values) for row, *values in firsts.itertuples(index=False)}


def _drawn_groups(participants: int, seed: str) -> NDArray[np.float64]:
    """Draw groups of participants: (GROUPS, participants), how much of a group each one is.

    The same groups serve every row, so that differences are paired.
    """
    rng = generator(seed, "sweep groups")
    counts = rng.multinomial(participants, np.full(participants, 1.0 / participants), size=GROUPS)
    weights: NDArray[np.float64] = counts / participants
    return weights


def _statistic(cells: NDArray[np.float64], order: Statistic) -> NDArray[np.float64]:
    """Give the statistic of every row of (rows, nuisance points, participants)."""
    by_nuisance = cells.mean(axis=2).T
    return by_nuisance.mean(axis=0) if order == "mean" else worst_tenth(by_nuisance)


def _of_groups(
    cells: NDArray[np.float64], weights: NDArray[np.float64], order: Statistic
) -> NDArray[np.float64]:
    """Give the statistic of one row's cells in every drawn group."""
    by_nuisance = cells @ weights.T
    drawn: NDArray[np.float64] = (
        by_nuisance.mean(axis=0) if order == "mean" else worst_tenth(by_nuisance)
    )
    return drawn


def _spread(cells: NDArray[np.float64], weights: NDArray[np.float64], order: Statistic) -> Spread:
    value = float(_statistic(cells[None], order)[0])
    return _with_interval(value, _of_groups(cells, weights, order), weights.shape[1], 1)


def _behind(
    cells: NDArray[np.float64],
    best: NDArray[np.float64],
    weights: NDArray[np.float64],
    order: Statistic,
    comparisons: int,
) -> Spread:
    value = float(_statistic(cells[None], order)[0] - _statistic(best[None], order)[0])
    drawn = _of_groups(cells, weights, order) - _of_groups(best, weights, order)
    return _with_interval(value, drawn, weights.shape[1], comparisons)


def _with_interval(
    value: float, drawn: NDArray[np.float64], participants: int, comparisons: int
) -> Spread:
    """Put a t interval of the bootstrap's standard error round a value.

    Percentiles of few participants are too narrow, and their far tails, which many comparisons ask
    for, are not reached by any number of draws; for a mean this is Student's own interval. One
    participant, or several who are all alike, show no spread to make an interval of.
    """
    if participants < 2 or drawn.std() <= ROUNDING * (1.0 + abs(value)):
        return Spread(value, UNKNOWN)
    error = float(drawn.std()) * sqrt(participants / (participants - 1))
    tail = (1.0 - CONFIDENCE) / (2 * comparisons)
    reach = float(student.ppf(1.0 - tail, participants - 1)) * error
    return Spread(value, Interval(value - reach, value + reach))


def _method(comparisons: int) -> str:
    return (
        "means over each participant's trials; 95 % intervals over participants (Student's t with "
        f"the standard error of {GROUPS} drawn groups); worst tenth: mean of the worst tenth of "
        "nuisance points; differences from the best row are paired by common seeds, their "
        f"intervals corrected for {comparisons} comparisons (Bonferroni)"
    )
