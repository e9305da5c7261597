"""One step of resolved rates as a linear problem, and its weighted, damped inverse."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.controllers.damping import Damping

Floats = NDArray[np.float64]

SINGULAR = 1e-9
"""sqrt det below this, in m^3, without damping: there is no inverse to speak of; ours."""


class Problem(NamedTuple):
    """One step's problem, in m and rad, in ground axes.

    rows : (m, n + 2) the rows of the Jacobian that count.
    wanted : (m,) the same rows of the hand's twist.
    free : (n + 2,) inverse weights; 0 for what must not move.
    gradient : (n + 2,) of the limits' potential, for the null space.
    top_rates : (n + 2,) greatest rates, either way.
    """

    rows: Floats
    wanted: Floats
    free: Floats
    gradient: Floats
    top_rates: Floats


class Solution(NamedTuple):
    """Rates (n + 2,), and the measures behind them; rates are zero where it is singular."""

    rates: Floats
    manipulability: float
    damping: float
    singular: bool = False


class Inverse(NamedTuple):
    """W^-1 J' (J W^-1 J' + k S)^-1 of eq. (16), not yet multiplied out.

    columns : (m, n + 2) J W^-1, whose transpose it begins with.
    square : (m, m) what is inverted.
    """

    columns: Floats
    square: Floats
    manipulability: float
    damping: float

    @classmethod
    def of(cls, problem: Problem, damping: Damping | None) -> Inverse:
        """Weigh and damp; k is eq. (13)."""
        columns = problem.rows * problem.free
        square = columns @ problem.rows.T
        measure = sqrt(max(float(np.linalg.det(square)), 0.0))
        k = 0.0 if damping is None else damping.at(measure)
        if damping is not None and k > 0.0:
            square.flat[:: len(square) + 1] += k * damping.per_row
        return cls(columns, square, measure, k)

    @property
    def singular(self) -> bool:
        """Whether it cannot be taken."""
        return self.damping == 0.0 and self.manipulability < SINGULAR

    def times(self, vector: Floats) -> Floats:
        """Multiply with a vector (m,), giving (n + 2,)."""
        rates: Floats = np.linalg.solve(self.square, vector) @ self.columns
        return rates
