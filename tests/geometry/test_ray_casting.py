"""Ranges to straight walls, against distances worked out by hand."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from omnistudy.geometry import PlanarPose
from omnistudy.geometry.ray_casting import Segment, cast

ORIGIN = PlanarPose(0.0, 0.0, 0.0)
AHEAD: Segment = ((2.0, -1.0), (2.0, 1.0))
"""A wall two metres ahead, from one metre right to one metre left."""

places = st.floats(-3.0, 3.0, allow_subnormal=False)


def ranges(*walls: Segment, angles: list[float], pose: PlanarPose = ORIGIN) -> list[float]:
    scan = cast(walls, pose, np.array(angles), 5.0)
    assert scan.max_range == 5.0
    assert scan.angles.tolist() == angles
    return [float(distance) for distance in scan.ranges]


def test_a_wall_ahead_square_on_and_aslant() -> None:
    # tan a = 3/4 would meet it 1.5 m aside, past its end; tan a = 5/12 meets it 5/6 m aside.
    aside, past = float(np.arctan2(5, 12)), float(np.arctan2(3, 4))
    found = ranges(AHEAD, angles=[0.0, aside, -aside, past, -past])
    assert found == pytest.approx([2.0, 2.0 * 13 / 12, 2.0 * 13 / 12, 5.0, 5.0])


def test_a_wall_ends_where_it_ends() -> None:
    within, past = float(np.arctan2(0.999, 2.0)), float(np.arctan2(1.001, 2.0))
    found = ranges(AHEAD, angles=[within, past, -within, -past])
    assert found == pytest.approx([sqrt(4 + 0.999**2), 5.0, sqrt(4 + 0.999**2), 5.0])


def test_no_ray_looks_backwards() -> None:
    assert ranges(AHEAD, angles=[pi, pi / 2, -pi / 2]) == [5.0, 5.0, 5.0]


def test_the_direction_of_a_wall_is_nothing() -> None:
    angles = [-0.4, -0.1, 0.0, 0.3]
    assert ranges(AHEAD, angles=angles) == ranges((AHEAD[1], AHEAD[0]), angles=angles)


def test_a_slanted_wall() -> None:
    # x + y = 1, met at (1, 0), (1/2, 1/2) and (0, 1).
    found = ranges(((2.0, -1.0), (-1.0, 2.0)), angles=[0.0, pi / 4, pi / 2])
    assert found == pytest.approx([1.0, 1 / sqrt(2), 1.0])


def test_the_nearest_wall_hides_those_behind_it() -> None:
    near: Segment = ((1.5, 0.1), (1.5, -0.1))
    for walls in ((AHEAD, near), (near, AHEAD)):
        assert ranges(*walls, angles=[0.0, 0.3])[0] == pytest.approx(1.5)
        assert ranges(*walls, angles=[0.3])[0] == pytest.approx(2.0 / np.cos(0.3))


def test_the_sensor_turns_and_moves_with_its_pose() -> None:
    # At (2, 3), looking along -y: the wall y = 1 is 2 m ahead, the wall x = 5 is 3 m to the left.
    walls: tuple[Segment, Segment] = (((0.0, 1.0), (4.0, 1.0)), ((5.0, 0.0), (5.0, 4.0)))
    found = ranges(*walls, angles=[0.0, pi / 2, -pi / 2], pose=PlanarPose(2.0, 3.0, -pi / 2))
    assert found == pytest.approx([2.0, 3.0, 5.0])


def test_a_wall_seen_edge_on_is_not_seen() -> None:
    assert ranges(((1.0, 0.0), (3.0, 0.0)), angles=[0.0]) == [5.0]


def test_an_end_of_a_wall_is_still_wall() -> None:
    assert ranges(((2.0, 0.0), (2.0, 1.0)), angles=[0.0]) == [2.0]


def test_what_is_farther_than_the_sensor_reaches_is_not_seen() -> None:
    scan = cast((AHEAD,), ORIGIN, np.array([0.0, 0.4]), 2.1)
    assert scan.ranges.tolist() == pytest.approx([2.0, 2.1])


def test_without_walls_every_ray_holds_the_greatest_range() -> None:
    assert ranges(angles=[-1.0, 0.0, 1.0]) == [5.0, 5.0, 5.0]


@given(st.tuples(places, places), st.tuples(places, places), st.floats(0.1, 0.9))
def test_a_ray_towards_a_point_of_a_wall_measures_how_far_it_is(
    start: tuple[float, float], end: tuple[float, float], share: float
) -> None:
    x = start[0] + share * (end[0] - start[0])
    y = start[1] + share * (end[1] - start[1])
    distance = sqrt(x * x + y * y)
    twice_area = abs(start[0] * end[1] - start[1] * end[0])
    assume(twice_area > 1e-3 and distance > 1e-3)  # neither edge-on nor on the sensor
    found = ranges((start, end), angles=[float(np.arctan2(y, x))])
    assert found == pytest.approx([distance], rel=1e-6)
