"""From readings to newtons a PWM step, against values worked out by hand and by scipy."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import linregress

from omnistudy.devices.stick.force_fit import Reading, fit
from omnistudy.errors.force_calibration import NoForceRead, TooFewReadings


def readings(*pairs: tuple[int, float]) -> list[Reading]:
    return [Reading(0, duty, force) for duty, force in pairs]


def test_a_small_example_by_hand() -> None:
    """Six readings: at ±100, ±200 and twice at 0.

    Regressors (1, d, -sign d) split into an even part, the offset, and an odd one. Odd half
    differences are 8 at 100 and 18 at 200 PWM: slope 10/100, border at 100 - 8/0.1 = 20. The mean
    of all is the offset, 0.
    """
    found = fit(
        "x",
        readings((100, 8.2), (-100, -7.8), (200, 17.8), (-200, -18.2), (0, 0.3), (0, -0.3)),
    )
    assert found.per_duty == pytest.approx(0.1)
    assert found.dead_band == pytest.approx(20.0)
    assert found.offset == pytest.approx(0.0, abs=1e-12)
    # Residuals are four of 0.2 and two of 0.3: s² = (4·0.04 + 2·0.09)/(6 - 3).
    variance = (4 * 0.04 + 2 * 0.09) / 3
    # Of (d, -sign): sums of squares 100 000 and 4, of products -600: the inverse's first is
    # 4/(100 000·4 - 600²) = 1/10 000. Student's t for three degrees of freedom is 3.1824.
    assert found.per_duty_95 == pytest.approx(3.182446 * sqrt(variance / 10_000), rel=1e-6)
    # At (1, 200, -1): 1/6 + (4·200² - 2·600·200 + 100 000)/40 000 = 1/6 + 0.5.
    assert found.prediction_95 == pytest.approx(
        3.182446 * sqrt(variance * (1 + 1 / 6 + 0.5)), rel=1e-6
    )
    assert (found.greatest, found.readings) == (200, 6)


def test_readings_inside_the_dead_band_do_not_flatten_the_slope() -> None:
    duties = (0, 10, -10, 20, -20, 40, -40, 80, -80, 160, -160)
    exact = [(duty, 0.3 + 0.05 * np.sign(duty) * max(0, abs(duty) - 30)) for duty in duties]
    found = fit("x", readings(*((duty, float(force)) for duty, force in exact)))
    assert found.per_duty == pytest.approx(0.05)
    assert found.dead_band == pytest.approx(30.0)
    assert found.offset == pytest.approx(0.3)
    assert found.per_duty_95 == pytest.approx(0.0, abs=1e-9)


def test_of_one_side_and_many_readings_the_slope_is_ordinary_regression_s() -> None:
    """With as many readings mirrored, slope and border are those of one side's straight line."""
    random = np.random.default_rng(7)
    duty = np.array([40, 80, 120, 160, 200] * 4)
    force = 0.052 * (duty - 12) + random.normal(0, 0.1, duty.size)
    both = [(int(d), float(f)) for d, f in zip(duty, force, strict=True)]
    found = fit("x", readings(*both, *((-d, -f) for d, f in both)))
    line = linregress(duty, force)
    assert found.per_duty == pytest.approx(line.slope)
    assert found.dead_band == pytest.approx(-line.intercept / line.slope)


@given(
    slope=st.floats(0.01, 0.2), border=st.floats(0, 30), offset=st.floats(-2, 2),
    unit=st.floats(0.1, 10),
)  # fmt: skip
def test_exact_readings_give_back_what_made_them_in_any_unit(
    slope: float, border: float, offset: float, unit: float
) -> None:
    duties = (0, 50, -50, 100, -100, 150, -150, 200, -200)
    made = [(d, unit * (offset + slope * np.sign(d) * max(0.0, abs(d) - border))) for d in duties]
    found = fit("y", readings(*((d, float(f)) for d, f in made)))
    assert found.per_duty == pytest.approx(unit * slope, rel=1e-9)
    assert found.dead_band == pytest.approx(border, abs=1e-6)
    assert found.offset == pytest.approx(unit * offset, abs=1e-9)


def test_the_intervals_hold_what_they_promise() -> None:
    """Of 400 noisy calibrations 95 % hold the true slope, and the next reading."""
    random = np.random.default_rng(11)
    duty = np.array([0, 50, -50, 100, -100, 150, -150, 200, -200] * 2)
    slope_held = reading_held = 0
    for _ in range(400):
        truth = 0.05 * np.sign(duty) * np.maximum(0, np.abs(duty) - 15)
        force = truth + random.normal(0, 0.2, duty.size)
        found = fit("x", readings(*zip(duty.tolist(), force.tolist(), strict=True)))
        slope_held += abs(found.per_duty - 0.05) < found.per_duty_95
        expected = found.offset + found.per_duty * (200 - found.dead_band)
        reading = 0.05 * 185 + random.normal(0, 0.2)
        reading_held += abs(reading - expected) < found.prediction_95
    # Three standard errors of a share of 0.95 in 400 are 0.033.
    assert slope_held / 400 == pytest.approx(0.95, abs=0.033)
    assert reading_held / 400 == pytest.approx(0.95, abs=0.033)


@pytest.mark.parametrize(
    "few",
    [
        [(100, 5.0), (-100, -5.0), (200, 10.0), (-200, -10.0), (0, 0.0)],
        [(100, 5.0)] * 10,
        [(100, 5.0), (-100, -5.0)] * 5,
        [(50, 2.5), (100, 5.0), (150, 7.5)] * 3,
    ],
    ids=["five", "one size", "one size either way", "one side"],
)
def test_readings_that_leave_it_open_are_refused(few: list[tuple[int, float]]) -> None:
    with pytest.raises(TooFewReadings, match="theta"):
        fit("theta", readings(*few))


@pytest.mark.parametrize("sign", [0.0, -0.05], ids=["dead motor", "read the wrong way round"])
def test_readings_that_do_not_grow_are_refused(sign: float) -> None:
    noise = (0.02, -0.01, 0.03, -0.02, 0.01, -0.03, 0.0)
    duties = (0, 50, -50, 100, -100, 200, -200)
    made = [(d, sign * d + n) for d, n in zip(duties, noise, strict=True)]
    with pytest.raises(NoForceRead, match="x: the readings do not grow"):
        fit("x", readings(*made))
