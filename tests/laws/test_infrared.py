"""The law of six infrared sensors, against eq. 2.4-2.6 worked out by hand.

The oblique sensors look 3-4-5 here: sin t = 0.6 ahead and cos t = 0.8 aside, from (0.2, 0.1).
"""

from __future__ import annotations

from math import asin, cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.straight_walls import scan_of

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws.boundary import RectangularBoundary
from omnistudy.laws.infrared import WIDEST_MISS, InfraredLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
SIDE = asin(0.6)
LAW = InfraredLaw(
    boundary=RectangularBoundary(half_length=0.2, half_width=0.2, layer_x=0.3, layer_y=0.3),
    stiffness=100.0,
    damping=10.0,
    oblique_angle=SIDE,
    oblique_ahead=0.2,
    oblique_aside=0.1,
)
"""Boundary: 0.5 m ahead and 0.5 m aside."""

ANGLES = (pi / 2, pi / 2 - SIDE, 0.0, 0.0, SIDE - pi / 2, -pi / 2)
ORIGINS = ((0.0, 0.2), (0.2, 0.1), (0.2, 0.05), (0.2, -0.05), (0.2, -0.1), (0.0, -0.2))
REACH = (0.3, 0.5, 0.3, 0.3, 0.5, 0.3)
"""m from each sensor to the boundary: 2 and 5 have 0.3 / 0.6 ahead and 0.4 / 0.8 aside."""


def robot_scan(
    depths: tuple[float, ...], rates: tuple[float, ...] | None = None, order: tuple[int, ...] = ()
) -> Scan:
    """Six sensors, each of which sees something so deep inside the boundary (0: nothing)."""
    places = list(order or range(6))
    ranges = [reach - depth if depth else 0.8 for reach, depth in zip(REACH, depths, strict=True)]
    return Scan(
        np.array(ANGLES)[places],
        np.array(ranges)[places],
        0.8,
        np.array(ORIGINS)[places],
        None if rates is None else np.array(rates)[places],
    )


@pytest.mark.parametrize(
    ("sensor", "wrench"),
    [
        # k·p = 100·0.1 = 10 N along the sensor; 2 and 5 have 6 N of it ahead, 8 N aside and an
        # arm of 0.2·0.8 - 0.1·0.6 = 0.1 m.
        (1, (0.0, -10.0, 0.0)),
        (2, (-6.0, -8.0, -1.0)),
        (3, (-10.0, 0.0, 0.0)),
        (4, (-10.0, 0.0, 0.0)),
        (5, (-6.0, 8.0, 1.0)),
        (6, (0.0, 10.0, 0.0)),
    ],
)
def test_each_sensor_pushes_back_along_its_ray(
    sensor: int, wrench: tuple[float, float, float]
) -> None:
    depths = tuple(0.1 if i == sensor else 0.0 for i in range(1, 7))
    assert LAW.wrench(robot_scan(depths), STILL) == pytest.approx(wrench, abs=1e-9)


def test_the_sensors_are_summed_not_averaged() -> None:
    wrench = LAW.wrench(robot_scan((0.1, 0.1, 0.1, 0.2, 0.0, 0.0)), STILL)
    assert wrench == pytest.approx((-6 - 10 - 20, -10 - 8, -1.0))


def test_what_closes_in_pushes_back_by_the_measured_rates() -> None:
    # Sensor 2 closes in at 0.5 m/s: 10·0.5 = 5 N more along it; 6 sees nothing, so its rate is
    # nothing either.
    scan = robot_scan((0.0, 0.1, 0.0, 0.0, 0.0, 0.0), rates=(0.0, -0.5, 0.0, 0.0, 0.0, -9.0))
    assert LAW.wrench(scan, PlanarTwist(0.3, 0.3, 1.0)) == pytest.approx((-9.0, -12.0, -1.5))


def test_without_rates_the_twist_tells_how_fast_a_wall_closes_in() -> None:
    # Along sensor 2: 0.6·0.5 + 0.8·0.25 + 0.1·1 = 0.6 m/s, so 6 N; along 3: 0.5 m/s, so 5 N.
    scan = robot_scan((0.0, 0.1, 0.1, 0.0, 0.0, 0.0))
    wrench = LAW.wrench(scan, PlanarTwist(0.5, 0.25, 1.0))
    assert wrench == pytest.approx((-16 * 0.6 - 15, -16 * 0.8, -1.6))


def test_rates_and_twist_agree_before_a_wall_square_to_the_sensor() -> None:
    depths = (0.0, 0.0, 0.1, 0.0, 0.0, 0.0)
    ahead = PlanarTwist(0.3, 0.0, 0.0)
    told = robot_scan(depths, rates=(0.0, 0.0, -0.3, 0.0, 0.0, 0.0))
    assert LAW.wrench(told, ahead) == pytest.approx(LAW.wrench(robot_scan(depths), ahead))


depths = st.tuples(*[st.sampled_from([0.0, 0.05, 0.1, 0.2])] * 6)
rates = st.tuples(*[st.floats(-1.0, 1.0)] * 6)
orders = st.permutations(range(6)).map(tuple)


@given(depths, rates, orders)
def test_the_order_of_the_sensors_in_the_scan_is_nothing(
    depth: tuple[float, ...], rate: tuple[float, ...], order: tuple[int, ...]
) -> None:
    expected = LAW.wrench(robot_scan(depth, rate), STILL)
    assert LAW.wrench(robot_scan(depth, rate, order), STILL) == pytest.approx(expected)


@given(depths, rates)
def test_what_is_mirrored_is_felt_mirrored(
    depth: tuple[float, ...], rate: tuple[float, ...]
) -> None:
    """Sensors 1 and 6 change places, 2 and 5, and 3 and 4."""
    fx, fy, tau = LAW.wrench(robot_scan(depth, rate), STILL)
    swapped = robot_scan(depth[::-1], rate[::-1])
    assert LAW.wrench(swapped, STILL) == pytest.approx((fx, -fy, -tau))
    assert LAW.wrench(robot_scan(depth, rate).mirrored(), STILL) == pytest.approx((fx, -fy, -tau))


@given(depths, st.tuples(st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.floats(-1.5, 1.5)))
def test_dampers_never_drive(depth: tuple[float, ...], moving: tuple[float, ...]) -> None:
    """What the dampers do to the moving hand is never positive work."""
    twist = PlanarTwist(*moving)
    still, moved = (LAW.wrench(robot_scan(depth), at) for at in (STILL, twist))
    assert np.dot(np.subtract(moved, still), twist) <= 1e-12


@pytest.mark.parametrize("told", [False, True])
def test_nothing_inside_the_boundary_is_no_force_bit_for_bit(told: bool) -> None:
    scan = robot_scan((0.0,) * 6, rates=(-1.0,) * 6 if told else None)
    values = np.array(InfraredLaw().wrench(scan, PlanarTwist(0.3, 0.3, 1.0)))
    assert values.tobytes() == np.zeros(3).tobytes()


def test_a_lidar_is_read_along_the_six_directions() -> None:
    """A wall ahead at 0.4 m: two sensors read its ray dead ahead, 0.1 m deep; the oblique ones
    read the ray nearest to 53.13 degrees, which is 19·2.8125 = 53.4375 and sees it beyond the
    boundary's corner: 0.4 / 0.596 = 0.67 m, the boundary 0.5 / 0.803 = 0.62 m."""
    assert LAW.wrench(scan_of([(1.0, 0.0, 0.4)], 2.0), STILL) == pytest.approx((-20.0, 0.0, 0.0))


def test_a_lidar_without_a_ray_dead_ahead_is_read_evenly() -> None:
    # Two rays at ±1 degree, 0.1 and 0.2 m inside the boundary's 0.5 / cos(1 degree).
    off = pi / 180
    reach = 0.5 / cos(off)
    scan = Scan(np.array([-off, off]), np.array([reach - 0.1, reach - 0.2]), 1.0)
    assert LAW.wrench(scan, STILL) == pytest.approx((-30.0, 0.0, 0.0))


@pytest.mark.parametrize(("share", "felt"), [(0.99, True), (1.01, False)])
def test_a_ray_too_far_off_is_not_taken_for_a_sensor(share: float, felt: bool) -> None:
    scan = Scan(np.array([-pi / 2 - share * WIDEST_MISS]), np.array([0.2]), 1.0)
    assert (LAW.wrench(scan, STILL).fy > 0.0) == felt


def test_the_default_numbers_before_a_wall() -> None:
    """At 0.30 m ahead: sensors 3 and 4 of a lidar are 0.05 m inside 0.35 m: 2·30·0.05 = 3 N. The
    oblique ones read 0.30·sqrt(2) = 0.424 m, just at 0.30·sqrt(2) where the side's boundary is."""
    fx, fy, tau = InfraredLaw().wrench(scan_of([(1.0, 0.0, 0.30)], 2.0), STILL)
    assert fx == pytest.approx(-3.0, abs=1e-6)
    assert (fy, tau) == pytest.approx((0.0, 0.0), abs=1e-9)


def test_an_oblique_sensor_out_of_line_with_the_centre_turns() -> None:
    """By default t = 45 degrees from (0.20, 0.10): an arm of 0.1·sin 45 = 0.0707 m. At 0.312 m
    the oblique ray is 0.1 m deep from the side's 0.30·sqrt(2) - 0.1·sqrt(2) (0.2828) m... worked
    with origins: (0.35 - 0.20)·sqrt(2) = 0.2121 m ahead is nearer."""
    quarter = pi / 4
    scan = Scan(np.array([quarter]), np.array([0.15 * 2**0.5 - 0.1]), 0.8, np.array([[0.20, 0.10]]))
    push = 30.0 * 0.1
    assert InfraredLaw().wrench(scan, STILL) == pytest.approx(
        (-push * sin(quarter), -push * cos(quarter), -push * 0.1 * sin(quarter))
    )
