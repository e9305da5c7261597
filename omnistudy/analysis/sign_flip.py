"""The paired sign-flip test: how far are differences from a mean of zero."""

from __future__ import annotations

from dataclasses import dataclass
from math import nan

import numpy as np
from numpy.typing import NDArray

from omnistudy.seeds import generator

EXACT_UP_TO = 16
"""Pairs whose 2^n sign patterns are all tried; beyond, DRAWS of them are drawn from the seed."""
DRAWS = 65_536


@dataclass(frozen=True, slots=True)
class SignFlip:
    """Two-sided p of a mean difference; NaN without a pair. n counts pairs."""

    mean_difference: float
    p: float
    n: int
    method: str


def sign_flip(differences: NDArray[np.float64], seed: str) -> SignFlip:
    """Test whether paired differences (n,) have mean zero (Fisher's randomisation test).

    Pairs with a missing half (NaN) are left out. With n pairs the smallest exact p is 2^(1-n).
    """
    pairs = differences[np.isfinite(differences)]
    n = int(pairs.size)
    if n == 0:
        return SignFlip(nan, nan, 0, "no pair")
    if n <= EXACT_UP_TO:
        patterns = (np.arange(2**n)[:, None] >> np.arange(n)) & 1
        method = f"exact, {2**n} sign patterns"
    else:
        patterns = generator(seed, "sign flip").integers(0, 2, size=(DRAWS, n))
        patterns[0] = 0  # the observed pattern belongs to the reference set
        method = f"{DRAWS} drawn sign patterns"
    sums = np.abs((1 - 2 * patterns) @ pairs)
    observed = abs(pairs.sum())
    as_far = sums >= observed - 1e-9 * max(1.0, float(np.abs(pairs).sum()))
    return SignFlip(float(pairs.mean()), float(as_far.mean()), n, method)
