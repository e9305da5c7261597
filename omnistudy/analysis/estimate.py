"""The smallest results: a mean with its spread, and an interval."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import nan

import numpy as np


@dataclass(frozen=True, slots=True)
class Estimate:
    """Mean and sample standard deviation of `n` values in `unit`.

    mean : NaN without a value. sd : NaN below two values.
    """

    mean: float
    sd: float
    n: int
    unit: str


@dataclass(frozen=True, slots=True)
class Interval:
    """From `low` to `high`, both included; NaN, NaN when it could not be computed."""

    low: float
    high: float

    @property
    def known(self) -> bool:
        """Tell whether there is a number in it."""
        return self.low <= self.high

    def meets(self, other: Interval) -> bool:
        """Tell whether the two have a value in common."""
        return self.low <= other.high and other.low <= self.high


UNKNOWN = Interval(nan, nan)


def estimate(values: Iterable[float], unit: str) -> Estimate:
    """Give mean and sample standard deviation (n - 1) of the finite values."""
    finite = np.array([value for value in values if np.isfinite(value)], dtype=np.float64)
    return Estimate(
        mean=float(finite.mean()) if finite.size else nan,
        sd=float(finite.std(ddof=1)) if finite.size > 1 else nan,
        n=int(finite.size),
        unit=unit,
    )
