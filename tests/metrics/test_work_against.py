from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors.analysis import UnequalColumns
from omnistudy.metrics import work_against


def test_two_newtons_against_ten_centimetres_are_a_fifth_of_a_joule() -> None:
    force = np.full((100, 1), -2.0)
    rate = np.full((100, 1), 0.1)
    assert work_against(force, rate, 0.01) == pytest.approx(0.2)


def test_help_is_not_given_back() -> None:
    there_and_back = np.array([[0.1], [-0.1]])
    assert work_against(np.full((2, 1), -2.0), there_and_back, 1.0) == pytest.approx(0.2)


def test_axes_are_summed_before_the_sign_is_looked_at() -> None:
    """A force across the motion does no work, whatever its axes do by themselves."""
    assert work_against(np.array([[1.0, -1.0]]), np.array([[0.1, 0.1]]), 1.0) == 0.0


@given(st.floats(-20, 20), st.floats(-20, 20), st.floats(-1, 1), st.floats(-1, 1))
def test_it_does_not_depend_on_which_way_is_called_forward(
    fx: float, fy: float, vx: float, vy: float
) -> None:
    force, rate = np.array([[fx, fy]]), np.array([[vx, vy]])
    assert work_against(-force, -rate, 0.5) == pytest.approx(work_against(force, rate, 0.5))


def test_columns_that_do_not_belong_together_are_refused() -> None:
    with pytest.raises(UnequalColumns, match="work_against was given columns of shapes"):
        work_against(np.zeros((3, 2)), np.zeros((3, 1)), 0.1)
