"""From readings of an instrument to newtons a PWM step, with what they leave uncertain."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from omnistudy.devices.stick.force_calibration import AxisForce
from omnistudy.errors.force_calibration import NoForceRead, TooFewReadings

LEAST = 6
"""Readings: three numbers are sought, and three more tell how sure they are (ours)."""
TOWARDS = 0.975
"""Quantile of Student's t for a two-sided interval of 95 %."""


class Reading(NamedTuple):
    """What an instrument read.

    axis : 0, 1, 2 for x, y, theta. duty : PWM steps. force : N; N·m for theta; with its sign.
    """

    axis: int
    duty: int
    force: float


class Line(NamedTuple):
    """A fitted line.

    found : offset, slope, slope·dead band. variance : of a reading.
    inverse : of rows'·rows, 3 by 3. freedom : readings less three.
    """

    found: NDArray[np.float64]
    variance: float
    inverse: NDArray[np.float64]
    freedom: int

    def half_width(self, spread: float) -> float:
        """Give half the width of a 95 % interval of what has `spread` times the variance."""
        return float(student.ppf(TOWARDS, self.freedom)) * sqrt(self.variance * spread)


def fit(axis: str, readings: Sequence[Reading]) -> AxisForce:
    """Fit force = offset + slope·(duty ∓ dead band) by least squares; readings of one axis.

    Readings inside the dead band say only what the offset is. Which those are is found by fitting
    anew until it no longer changes. Intervals are the usual ones of linear regression (Draper and
    Smith 1998, ch. 1 and 5), with the dead band's border taken as known.
    Raises TooFewReadings, NoForceRead.
    """
    duty = np.array([one.duty for one in readings], dtype=np.float64)
    force = np.array([one.force for one in readings], dtype=np.float64)
    band = 0.0
    while True:
        rows = _rows(duty, band)
        line = _line(axis, rows, force)
        _, slope, lost = (float(number) for number in line.found)
        # It only widens, so that it comes to an end.
        band = max(band, lost / slope)
        if np.array_equal(rows, _rows(duty, band)):
            return _told(rows, line)


def _rows(duty: NDArray[np.float64], band: float) -> NDArray[np.float64]:
    """Give the regressors (1, duty, -sign of duty), the last two 0 inside the dead band."""
    beyond = np.abs(duty) > band
    return np.column_stack(
        (np.ones_like(duty), np.where(beyond, duty, 0.0), np.where(beyond, -np.sign(duty), 0.0))
    )


def _line(axis: str, rows: NDArray[np.float64], force: NDArray[np.float64]) -> Line:
    """Fit by least squares; raises TooFewReadings, NoForceRead."""
    if len(force) < LEAST or np.linalg.matrix_rank(rows) < 3:
        raise TooFewReadings(axis, len(force), LEAST)
    inverse: NDArray[np.float64] = np.linalg.inv(rows.T @ rows).astype(np.float64)
    found = inverse @ (rows.T @ force)
    freedom = len(force) - 3
    line = Line(found, float(np.sum((force - rows @ found) ** 2)) / freedom, inverse, freedom)
    half_width = line.half_width(inverse[1, 1])
    if found[1] <= half_width:
        raise NoForceRead(axis, float(found[1]), half_width)
    return line


def _told(rows: NDArray[np.float64], line: Line) -> AxisForce:
    offset, slope, lost = (float(number) for number in line.found)
    greatest = float(np.abs(rows[:, 1]).max())
    at = np.array((1.0, greatest, -1.0))
    return AxisForce(
        per_duty=slope,
        per_duty_95=line.half_width(line.inverse[1, 1]),
        dead_band=max(0.0, lost / slope),
        offset=offset,
        greatest=int(greatest),
        prediction_95=line.half_width(1.0 + float(at @ line.inverse @ at)),
        readings=len(rows),
    )
