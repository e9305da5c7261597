"""How near a range's ends something is, as the thesis weighs it (Farelo 2009, eq. 18 to 21)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def limit_potential(value: Floats, lower: Floats, upper: Floats) -> Floats:
    """Give each term of H, eq. (18), (20): 1 in the middle of the range, infinite at its ends."""
    with np.errstate(divide="ignore"):
        terms: Floats = 0.25 * (upper - lower) ** 2 / ((upper - value) * (value - lower))
    return terms


def limit_gradient(value: Floats, lower: Floats, upper: Floats) -> Floats:
    """Give each derivative of H, eq. (19), (21), per unit of the value: 0 in the middle.

    Positive above the middle; infinite at the ends, and finite again beyond them.
    """
    span = upper - lower
    room = (upper - value) * (value - lower)
    with np.errstate(divide="ignore"):
        slopes: Floats = 0.25 * span * span * (2.0 * value - upper - lower) / (room * room)
    return slopes


def limit_weights(
    gradient: Floats, before: Floats, value: Floats, lower: Floats, upper: Floats
) -> Floats:
    """Give what limit avoidance adds to each weight: nothing for what moves away from its limit.

    gradient, before : derivative of H now and at the step before.
    Beyond a limit, moving on is infinitely expensive and coming back is free (WMRA_Opt, p. 127).
    """
    now, last = np.abs(gradient), np.abs(before)
    within = (value > lower) & (value < upper)
    away = now < last
    weights: Floats = np.where(within, np.where(away, 0.0, now), np.where(away, np.inf, now))
    weights[~within & (now > last)] = 0.0
    return weights
