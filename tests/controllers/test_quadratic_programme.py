"""Quadratic programmes whose answer is known."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from omnistudy.controllers.quadratic_programme import Programme, solve


def programme(lower: tuple[float, ...], upper: tuple[float, ...]) -> Programme:
    """1/2 |x - (1, 2)|^2 with bounds on both and on their sum."""
    return Programme(
        np.eye(2), np.array((-1.0, -2.0)), np.ones((1, 2)), np.array(lower), np.array(upper)
    )


def test_without_a_bound_in_the_way_the_centre_is_best() -> None:
    best = solve(programme((-9.0, -9.0, -9.0), (9.0, 9.0, 9.0)))
    assert best.x == pytest.approx((1.0, 2.0))
    assert best.prices == pytest.approx((0.0, 0.0, 0.0))


def test_a_bound_of_a_variable_holds_and_has_a_price() -> None:
    best = solve(programme((-9.0, -9.0, -9.0), (9.0, 0.5, 9.0)))
    assert best.x == pytest.approx((1.0, 0.5))
    assert best.prices == pytest.approx((0.0, 1.5, 0.0))


def test_a_bound_of_a_row_is_shared() -> None:
    best = solve(programme((-9.0, -9.0, -9.0), (9.0, 9.0, 1.0)))
    assert best.x == pytest.approx((0.0, 1.0))


def test_bounds_that_exclude_each_other_have_no_answer() -> None:
    assert solve(programme((1.0, 1.0, -9.0), (2.0, 2.0, 1.0))).x is None


def test_the_solver_is_not_loaded_before_it_is_needed() -> None:
    code = "import sys, omnistudy.controllers.dual_qp; sys.exit('daqp' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
