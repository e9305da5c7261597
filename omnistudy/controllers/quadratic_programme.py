"""A small convex quadratic programme with bounds, solved by DAQP (Arnstroem 2022, MIT)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

ITERATIONS = 500
"""More than any step needs; keeps a step finite."""


class Programme(NamedTuple):
    """Minimise 1/2 x'Hx + f'x with lower <= (x, Ax) <= upper.

    square : H (n, n), positive definite. linear : f (n,). rows : A (m, n).
    lower, upper : (n + m,), first of the variables, then of the rows.
    """

    square: Floats
    linear: Floats
    rows: Floats
    lower: Floats
    upper: Floats


class Optimum(NamedTuple):
    """The best x (n,) or None when the solver gave up, and the price of each bound (n + m,)."""

    x: Floats | None
    prices: Floats


def solve(programme: Programme) -> Optimum:
    """Solve it."""
    # Imported here: loading the solver's library would slow every command down.
    import daqp

    x, _, flag, told = daqp.solve(*programme[:3], programme.upper, programme.lower)
    return Optimum(x if flag > 0 else None, told["lam"])
