"""Which spread of skills gives a group of people the collisions that were counted."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.session import CannotCalibrate
from omnistudy.seeds import generator

FREE_TRIALS = (np.arange(1.0, 4.0), np.arange(4.0, 7.0))
"""Places of the no-feedback trials in the published order: half the people meet them first."""
GROUP = 8
"""People in the published study, over whom its best and worst were found."""
GROUPS = 1000
"""Groups drawn to find the expected distance between best and worst."""
BISECTIONS = 24


@dataclass(frozen=True, slots=True)
class Targets:
    """No-feedback collisions to be met: mean of all, and means of the best and worst of eight."""

    mean: float
    best: float
    worst: float

    @property
    def log_range(self) -> float:
        """Logarithm of worst over best."""
        return float(np.log(self.worst / self.best))


@dataclass(frozen=True, slots=True)
class ResponsePoint:
    """Mean no-feedback collisions of `trials` trials driven at one skill."""

    skill: float
    collisions: float
    trials: int


class Population:
    """People whose skills are log-normal, met at the published places of the order.

    Between the measured points collisions are interpolated, beyond them the end segment goes on.
    """

    def __init__(self, response: Sequence[ResponsePoint], learning: float, seed: str) -> None:
        self._skill = np.array([0.0, *(point.skill for point in response)])
        counts = np.array([0.0, *(point.collisions for point in response)])
        self._collisions = np.maximum.accumulate(counts)
        draws = generator(seed, "population").standard_normal((GROUPS, GROUP))
        self._draws = draws
        practice = [np.power(places, -learning) for places in FREE_TRIALS]
        self._practice = np.stack([practice[person % 2] for person in range(GROUP)])

    def _counts(self, median: float, spread: float) -> NDArray[np.float64]:
        """Mean collisions of each person of each group, (GROUPS, GROUP)."""
        first = median * np.exp(spread * self._draws)
        skills = first[:, :, None] * self._practice[None, :, :]
        top, below = self._skill[-1], self._skill[-2]
        slope = (self._collisions[-1] - self._collisions[-2]) / (top - below)
        inside = np.interp(skills, self._skill, self._collisions)
        counts: NDArray[np.float64] = (inside + slope * np.maximum(0.0, skills - top)).mean(axis=2)
        return counts

    def mean(self, median: float, spread: float) -> float:
        """Give the expected collisions a trial."""
        return float(self._counts(median, spread).mean())

    def log_range(self, median: float, spread: float) -> float:
        """Give the expected logarithm of the worst person's over the best person's mean."""
        counts = np.maximum(self._counts(median, spread), 0.1)
        return float(np.log(counts.max(axis=1) / counts.min(axis=1)).mean())

    def meeting(self, targets: Targets) -> tuple[float, float]:
        """Give median and spread of skill that meet the targets; raises CannotCalibrate."""
        top = 4.0 * float(self._skill[-1])
        if self.mean(top, 0.0) < targets.mean:
            raise CannotCalibrate(targets.mean, self.mean(top, 0.0), top)

        def median_for(spread: float) -> float:
            return _crossing(lambda median: self.mean(median, spread), targets.mean, 0.0, top)

        spread = _crossing(
            lambda value: self.log_range(median_for(value), value), targets.log_range, 0.0, 1.5
        )
        return round(median_for(spread), 3), round(spread, 3)


def _crossing(function: Callable[[float], float], target: float, low: float, high: float) -> float:
    """Bisect a rising function for the argument at which it passes the target."""
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if function(middle) < target:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
