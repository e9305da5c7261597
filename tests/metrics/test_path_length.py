"""Lengths of driven ways."""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.errors.analysis import UnequalColumns
from omnistudy.metrics import path_length


def test_legs_of_a_right_triangle() -> None:
    assert path_length(np.array([0.0, 3.0, 3.0]), np.array([0.0, 0.0, 4.0])) == 7.0


def test_rows_without_a_place_are_left_out() -> None:
    x = np.array([0.0, np.nan, 3.0])
    assert path_length(x, np.array([0.0, 1.0, 4.0])) == 5.0
    assert path_length(np.array([1.0]), np.array([1.0])) == 0.0


def test_unequal_columns_are_refused() -> None:
    with pytest.raises(UnequalColumns):
        path_length(np.zeros(3), np.zeros(2))
