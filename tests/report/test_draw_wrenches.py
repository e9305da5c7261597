"""Traces of force and torque."""

from __future__ import annotations

import numpy as np

from omnistudy.report.draw_wrenches import broken_at_gaps


def test_no_line_is_drawn_over_the_time_that_a_part_was_left() -> None:
    twice_inside = np.array([0.0, 0.05, 0.1, 5.0, 5.05, 5.1])
    assert np.isnan(broken_at_gaps(twice_inside)).tolist() == [False, False, True] + [False] * 3
    whole = np.arange(10) / 20
    assert np.array_equal(broken_at_gaps(whole), whole)
