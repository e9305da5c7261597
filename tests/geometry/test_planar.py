"""Poses on the floor and angles, by hand and by properties."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.geometry import PlanarPose, Scan, wrapped
from omnistudy.scene import Body, Box, Region

coordinates = st.floats(-100.0, 100.0)
angles = st.floats(-20.0, 20.0)


def test_left_of_a_robot_that_looks_north_is_west() -> None:
    pose = PlanarPose(2.0, 1.0, pi / 2)
    assert pose.to_world(0.0, 1.0) == pytest.approx((1.0, 1.0))
    assert pose.to_world(1.0, 0.0) == pytest.approx((2.0, 2.0))
    assert pose.to_local(2.0, 3.0) == pytest.approx((2.0, 0.0))


@given(coordinates, coordinates, angles, coordinates, coordinates)
def test_to_local_undoes_to_world(x: float, y: float, theta: float, px: float, py: float) -> None:
    pose = PlanarPose(x, y, theta)
    assert pose.to_local(*pose.to_world(px, py)) == pytest.approx((px, py), abs=1e-9)


@pytest.mark.parametrize(
    ("angle", "expected"),
    [(0.0, 0.0), (pi, -pi), (-pi, -pi), (3 * pi / 2, -pi / 2), (7.0, 7.0 - 2 * pi)],
)
def test_wrapped(angle: float, expected: float) -> None:
    assert wrapped(angle) == pytest.approx(expected)


@given(angles)
def test_wrapping_keeps_the_direction(angle: float) -> None:
    inside = wrapped(angle)
    assert -pi <= inside < pi
    turns = (angle - inside) / (2 * pi)
    assert turns == pytest.approx(round(turns), abs=1e-9)


def test_a_mirrored_scan_swaps_left_and_right() -> None:
    scan = Scan(np.array([-0.5, 0.0, 1.0]), np.array([1.0, 2.0, 3.0]), 4.0).mirrored()
    assert scan.angles.tolist() == [0.5, 0.0, -1.0]
    assert scan.ranges.tolist() == [1.0, 2.0, 3.0]


def test_a_region_knows_what_lies_in_it() -> None:
    ell = Region(name="L", polygon=((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)))
    inside = [(0.5, 0.5), (1.5, 0.5), (0.5, 1.5)]
    outside = [(1.5, 1.5), (-0.1, 0.5), (2.1, 0.5), (0.5, 2.1)]
    assert all(ell.contains(*point) for point in inside)
    assert not any(ell.contains(*point) for point in outside)


def test_a_box_with_a_side_of_nothing_is_refused() -> None:
    with pytest.raises(ValueError, match="greater than 0"):
        Body(name="w", role="wall", geometry=Box(x=0, y=1, z=1), x=0, y=0, z=0.5)
