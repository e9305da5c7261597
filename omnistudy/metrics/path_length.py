"""How far a robot was driven."""

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.analysis import UnequalColumns


def path_length(x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
    """Give the length in m of the polyline through positions x, y (n,) in m.

    Rows with NaN are left out; fewer than two rows have length 0. Sampling cuts corners: at 20 Hz
    and 0.36 m/s a right angle loses at most 1 cm. Raises UnequalColumns.
    """
    if x.shape != y.shape or x.ndim != 1:
        raise UnequalColumns("path_length", x.shape, y.shape)
    known = np.isfinite(x) & np.isfinite(y)
    return float(np.hypot(np.diff(x[known]), np.diff(y[known])).sum())
