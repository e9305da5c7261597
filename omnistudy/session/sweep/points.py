"""Which combinations of values there are: lists crossed, intervals sampled together."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import ceil, floor, log2
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.sweep import IntervalNeedsSamples, SamplesNeedInterval
from omnistudy.seeds import generator
from omnistudy.session.sweep.question import Role
from omnistudy.session.sweep.variables import Interval, Swept

DIGITS = 6
"""Significant digits of a sampled value, so that a page can state the very value that ran."""


def combinations(
    swept: Sequence[Swept], role: Role, samples: int | None, seed: str
) -> tuple[dict[str, Any], ...]:
    """Give every combination of a role's values, one mapping from key to value each.

    Lists are crossed; intervals are sampled together by one scrambled Sobol sequence (Owen 1998),
    which is crossed with the lists. Without a variable of the role there is one, empty.

    Raises IntervalNeedsSamples.
    """
    own = [one for one in swept if one.variable.role == role]
    lists = [one for one in own if not isinstance(one.values, Interval)]
    intervals = [one for one in own if isinstance(one.values, Interval)]
    listed = [
        dict(zip((one.variable.key for one in lists), values, strict=True))
        for values in product(*(one.values for one in lists if isinstance(one.values, tuple)))
    ]
    if not intervals:
        return tuple(listed)
    if samples is None:
        raise IntervalNeedsSamples(intervals[0].variable.key)
    drawn = sobol(len(intervals), samples, f"{seed} {role}")
    sampled = [
        {
            one.variable.key: _within(one.values, float(unit))
            for one, unit in zip(intervals, row, strict=True)
            if isinstance(one.values, Interval)
        }
        for row in drawn
    ]
    return tuple({**one, **other} for one in listed for other in sampled)


def require_interval(swept: Sequence[Swept], samples: int | None) -> None:
    """Raise SamplesNeedInterval for a number of samples that nothing asks for."""
    if samples is not None and not any(isinstance(one.values, Interval) for one in swept):
        raise SamplesNeedInterval


def sobol(dimensions: int, samples: int, seed: str) -> NDArray[np.float64]:
    """Give the first `samples` points (samples, dimensions) of a scrambled Sobol sequence."""
    from scipy.stats import qmc

    engine = qmc.Sobol(dimensions, scramble=True, rng=generator(seed, "sobol"))
    drawn: NDArray[np.float64] = engine.random_base2(ceil(log2(samples)))[:samples]
    return drawn


def _within(interval: Interval, unit: float) -> float | int:
    """Give the value at a place in [0, 1) of an interval."""
    if interval.whole:
        return floor(interval.low + unit * (interval.high - interval.low + 1))
    return rounded(interval.low + unit * (interval.high - interval.low), interval)


def rounded(value: float, interval: Interval) -> float:
    """Round to DIGITS, inside the interval."""
    return min(max(float(f"{value:.{DIGITS}g}"), interval.low), interval.high)
