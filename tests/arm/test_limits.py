"""How near a range's ends something is."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.arm.limits import limit_gradient, limit_potential, limit_weights

LOWER, UPPER = np.full(7, -2.0), np.full(7, 2.0)


def test_in_mid_range_every_joint_counts_one_and_pushes_nothing() -> None:
    assert limit_potential(np.zeros(7), LOWER, UPPER).sum() == 7.0
    assert (limit_gradient(np.zeros(7), LOWER, UPPER) == 0.0).all()


@given(st.floats(-1.0, 3.0))
def test_the_gradient_is_the_slope(u: float) -> None:
    lower, upper, h = np.array([-1.5]), np.array([3.5]), 1e-6
    slope = (
        limit_potential(np.array([u + h]), lower, upper)
        - limit_potential(np.array([u - h]), lower, upper)
    ) / (2 * h)
    assert limit_gradient(np.array([u]), lower, upper) == pytest.approx(slope, rel=1e-4, abs=1e-6)


@given(st.floats(-0.99, 0.99))
def test_the_gradient_in_half_ranges(u: float) -> None:
    # 2u / (h (1 - u^2)^2) with half range h = 2
    found = limit_gradient(np.array([2.0 * u]), LOWER[:1], UPPER[:1])
    assert found == pytest.approx(u / (1 - u * u) ** 2)


def test_at_a_limit_both_are_infinite() -> None:
    at = np.array([2.0])
    assert limit_potential(at, LOWER[:1], UPPER[:1])[0] == inf
    assert limit_gradient(at, LOWER[:1], UPPER[:1])[0] == inf


@pytest.mark.parametrize(
    ("value", "now", "before", "added"),
    [
        (1.0, 3.0, 2.0, 3.0),  # nearing its limit
        (-1.0, -3.0, -2.0, 3.0),  # nearing the other one
        (1.0, 2.0, 3.0, 0.0),  # leaving it
        (2.5, 2.0, 3.0, inf),  # beyond it, and going on
        (2.5, 3.0, 2.0, 0.0),  # beyond it, and coming back
    ],
)
def test_only_what_nears_its_limit_gets_dearer(
    value: float, now: float, before: float, added: float
) -> None:
    given_numbers = [np.array([x]) for x in (now, before, value, -2.0, 2.0)]
    assert limit_weights(*given_numbers) == added
