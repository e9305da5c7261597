"""A driver's place on the way: found again near the last one, never far ahead or behind."""

from __future__ import annotations

from itertools import pairwise
from math import hypot

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.operators.way import Way
from omnistudy.worlds import Leg

THERE_AND_BACK = Leg(target="red", path=((0, 0), (4, 0), (4, 0), (4, 2), (4, 0), (0, 0)))


def has_length(path: list[tuple[float, float]]) -> bool:
    return all(hypot(bx - ax, by - ay) > 1e-3 for (ax, ay), (bx, by) in pairwise(path))


ROUND_A_CORNER = Leg(target="red", path=((0, 0), (4, 0), (4, 2)))

corners = st.lists(
    st.tuples(st.floats(-5, 5), st.floats(-5, 5)), min_size=2, max_size=6, unique=True
).filter(has_length)
ways = corners.map(lambda path: Way(Leg(target="t", path=tuple(path))))
shares = st.floats(0.0, 1.0)


def test_length_and_points_by_hand() -> None:
    way = Way(THERE_AND_BACK)
    assert way.length == 12.0
    assert way.at(3.0) == (3.0, 0.0)
    assert way.at(5.0) == (4.0, 1.0)
    assert way.at(7.5) == (4.0, 0.5)
    assert way.at(-1.0) == (0.0, 0.0)
    assert way.at(99.0) == (0.0, 0.0)


def test_nearest_by_hand() -> None:
    way = Way(THERE_AND_BACK)
    assert way.nearest(1.0, 0.7, 0.0, 12.0) == 1.0
    assert way.nearest(1.0, 0.7, 9.0, 12.0) == 11.0  # the way back, where only that is looked at
    assert way.nearest(1.0, 0.7, 2.0, 3.0) == 2.0
    assert way.nearest(4.9, 1.5, 0.0, 6.0) == 5.5


def test_place_follows_the_driver() -> None:
    way = Way(ROUND_A_CORNER)
    places = [way.find(x / 10, 0.1) for x in range(41)] + [
        way.find(4.1, y / 10) for y in range(1, 21)
    ]
    assert places == sorted(places)
    assert places[20] == 2.0
    assert places[-1] == 6.0
    assert way.find(4.0, 1.8) == 5.8  # and back a little when the driver backs


def test_a_driver_far_off_the_way_is_not_carried_on_along_it() -> None:
    way = Way(THERE_AND_BACK)
    way.find(1.0, 0.0)
    assert way.find(4.0, 1.9) <= 2.0  # a metre ahead at most
    way.place = 3.0
    assert way.find(0.0, 0.0) >= 2.7  # a foot behind at most


@given(ways, shares)
def test_a_point_of_the_way_is_nearest_to_itself(way: Way, share: float) -> None:
    s = share * way.length
    x, y = way.at(s)
    found = way.at(way.nearest(x, y, 0.0, way.length))
    assert found == pytest.approx((x, y), abs=1e-6)


@given(ways, st.floats(-6, 6), st.floats(-6, 6))
def test_nothing_on_the_way_is_nearer_than_the_nearest(way: Way, x: float, y: float) -> None:
    found = way.at(way.nearest(x, y, 0.0, way.length))
    nearest = hypot(found[0] - x, found[1] - y)
    for i in range(101):
        px, py = way.at(i / 100 * way.length)
        assert nearest <= hypot(px - x, py - y) + 1e-9


@given(ways, st.floats(-6, 6), st.floats(-6, 6), shares, shares)
def test_the_window_is_kept(way: Way, x: float, y: float, a: float, b: float) -> None:
    low, high = sorted((a * way.length, b * way.length))
    assert low - 1e-9 <= way.nearest(x, y, low, high) <= high + 1e-9


@given(ways, shares, shares)
def test_arc_length_is_length(way: Way, a: float, b: float) -> None:
    (ax, ay), (bx, by) = way.at(a * way.length), way.at(b * way.length)
    assert hypot(bx - ax, by - ay) <= abs(b - a) * way.length + 1e-9
