"""Damping near singular configurations: eq. (13), in the thesis's units and in ones that work."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
DampingName = Literal["legacy", "scaled"]


class Damping(NamedTuple):
    """k = k0 (1 - w/w0)^2 below w0, else 0, added to every row of J W^-1 J' in scaled units.

    strength : k0.
    threshold : w0, for w of rows in m and rad.
    per_row : 1/scale^2 of each row, (rows,).
    """

    strength: float
    threshold: float
    per_row: Floats

    def at(self, manipulability: float) -> float:
        """Give k."""
        if manipulability >= self.threshold:
            return 0.0
        return self.strength * (1.0 - manipulability / self.threshold) ** 2


class _Numbers(NamedTuple):
    linear: float
    angular: float
    threshold: float
    strength: float


_NUMBERS: dict[tuple[DampingName, bool], _Numbers] = {
    # Farelo 2009, WMRA_Opt, p. 127: one k for rows in mm and in rad
    ("legacy", True): _Numbers(1000.0, 1.0, 34e6, 13.0),
    ("legacy", False): _Numbers(1000.0, 1.0, 20e6, 350000.0),
    # ours: rad times half a metre, so that one k means the same to all rows
    ("scaled", True): _Numbers(1.0, 0.5, 3e-3, 1e-3),
    ("scaled", False): _Numbers(1.0, 0.5, 3e-3, 1e-3),
}
"""(name, chair moves too) -> row scales, w0 and k0 in units of the scaled rows."""


def damping(name: DampingName, with_chair: bool, rows: int) -> Damping:
    """Give a damping for 3 rows (position) or 6 (pose)."""
    numbers = _NUMBERS[name, with_chair]
    scale = np.array([numbers.linear] * 3 + [numbers.angular] * 3)[:rows]
    return Damping(numbers.strength, numbers.threshold / float(np.prod(scale)), scale**-2.0)
