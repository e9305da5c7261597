"""Damping by eq. (13), as printed and with one unit."""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.controllers.damping import damping


def test_the_printed_numbers() -> None:
    legacy = damping("legacy", with_chair=True, rows=6)
    # w0 is 34e6 mm^3; half of it gives a quarter of k0 = 13
    assert legacy.at(34e6 / 1e9) == 0.0
    assert legacy.at(17e6 / 1e9) == pytest.approx(13.0 / 4.0)
    assert legacy.at(0.0) == 13.0
    alone = damping("legacy", with_chair=False, rows=6)
    assert alone.at(0.0) == 350000.0
    assert alone.at(20e6 / 1e9) == 0.0


def test_in_metres_the_printed_k_hardly_damps_ways_and_drowns_turns() -> None:
    # one k for rows in mm and in rad: a million times less for those in m
    assert damping("legacy", with_chair=True, rows=6).per_row == pytest.approx(
        (1e-6, 1e-6, 1e-6, 1.0, 1.0, 1.0)
    )


def test_scaled_rows_are_all_metres() -> None:
    scaled = damping("scaled", with_chair=True, rows=6)
    assert scaled.per_row == pytest.approx((1.0, 1.0, 1.0, 4.0, 4.0, 4.0))
    # w of rows in m and rad is 8 times w of rows in m
    assert scaled.at(8 * 3e-3) == 0.0
    assert scaled.at(4 * 3e-3) == pytest.approx(1e-3 / 4.0)


def test_position_alone_has_three_rows() -> None:
    scaled = damping("scaled", with_chair=True, rows=3)
    assert np.shape(scaled.per_row) == (3,)
    assert scaled.at(3e-3) == 0.0
