"""How much a force works against the hand that moves the stick."""

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.analysis import UnequalColumns


def work_against(force: NDArray[np.float64], rate: NDArray[np.float64], step: float) -> float:
    """Give the work in J that the hand does against a force: the integral of max(0, -F·q').

    force, rate : (n, axes), N and m/s (twist: N·m and rad/s), at the same moments, `step` s apart.
    Where the force helps, nothing is given back. Raises UnequalColumns.
    """
    if force.shape != rate.shape or force.ndim != 2:
        raise UnequalColumns("work_against", force.shape, rate.shape)
    power = np.einsum("ij,ij->i", force, rate)
    return float(np.maximum(0.0, -power).sum() * step)
