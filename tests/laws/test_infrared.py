"""The law of six infrared sensors, against eq. 2.4-2.6 worked out by hand.

The oblique sensors look 3-4-5 here: sin t = 0.6 ahead and cos t = 0.8 aside, from (0.2, 0.1).
"""

from __future__ import annotations

from dataclasses import replace
from math import asin, cos, exp, pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.straight_walls import scan_of
from numpy.typing import NDArray

from omnistudy.controllers.rate import RateController
from omnistudy.devices import DeviceState, Hand
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws import Sensed
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


def test_the_default_robot_before_a_wall() -> None:
    """The wall 0.05 m before the front edge. Sensors 3 and 4 are 0.15 - 0.05 = 0.10 m deep, 2 and 5
    sqrt(2) times that, of which 1/sqrt(2) pushes back: 20·(0.1 + 0.1 + 0.1 + 0.1) = 8 N."""
    fx, fy, tau = InfraredLaw().wrench(ring(ahead=0.05), STILL)
    assert fx == pytest.approx(-8.0)
    assert (fy, tau) == pytest.approx((0.0, 0.0), abs=1e-12)


def test_the_default_robot_beside_a_wall_turns_away_from_it() -> None:
    """The wall 0.02 m beside the left edge, 0.20 m from the middle line. Sensor 1 is 0.10 m deep.
    Sensor 2 is 0.10·sqrt(2) m from the wall and (0.35 - 0.20)·sqrt(2) m from the boundary ahead of
    it: 0.05·sqrt(2) m deep, 20·0.05 = 1 N back and 1 N right on an arm of 0.20 - 0.10 m."""
    wrench = InfraredLaw().wrench(ring(left=0.02), STILL)
    assert wrench == pytest.approx((-1.0, -20 * 0.1 - 1.0, -1.0 * 0.1))


def ring(ahead: float = 9.0, left: float = 9.0, speed: float = 0.0, seen: float = 0.8) -> Scan:
    """What six sensors of a robot of 0.40 by 0.36 m see of walls so far from its edges, in m.

    speed : m/s ahead, told as rates the way wheel encoders do, as if all stood square to the rays.
    """
    oblique = min(ahead, left + 0.08) * sqrt(2)
    slanted = speed / sqrt(2)
    return Scan(
        np.array([pi / 2, pi / 4, 0.0, 0.0, -pi / 4, -pi / 2]),
        np.minimum([left, oblique, ahead, ahead, ahead * sqrt(2), 9.0], seen),
        seen,
        np.array([[0, 0.18], [0.2, 0.1], [0.2, 0.05], [0.2, -0.05], [0.2, -0.1], [0, -0.18]]),
        np.array([0.0, -slanted, -speed, -speed, -slanted, 0.0]),
    )


@pytest.mark.parametrize("push", [2.5, 4.0, 6.0])
def test_a_stick_pushed_against_a_wall_comes_to_rest(push: float) -> None:
    """50 Hz, an 8 Hz low-pass, wheels that lag by 80 ms: within a millimetre after ten seconds."""
    gaps = driven_at_a_wall(InfraredLaw(), push)
    assert gaps.min() > 0.02
    assert np.ptp(gaps[-480:]) < 0.001


def test_five_times_as_stiff_shakes() -> None:
    assert np.ptp(driven_at_a_wall(InfraredLaw(stiffness=100.0), 4.0)[-480:]) > 0.02


def driven_at_a_wall(law: InfraredLaw, push: float) -> NDArray[np.float64]:
    """Push the published stick steadily ahead, in N, in a hand that adds nothing; give the gaps."""
    stick, controller = SimulatedStick().connect(240), RateController()
    hand = Hand((push / 0.1, 0.0, 0.0), (0.1, 0.1, 0.1), (0.0,) * 3, (0.0,) * 3)
    device, twist = DeviceState((0.0,) * 3, (0.0,) * 3), STILL
    gap, speed, gaps = 0.3, 0.0, []
    seen = ring(ahead=gap).ranges
    for step in range(12 * 240):
        if step * 50 // 240 != (step - 1) * 50 // 240:
            now = ring(gap, speed=speed)
            seen = now.ranges + exp(-2 * pi * 8 / 50) * (seen - now.ranges)
            x, y, theta = device.position
            stick.render(
                law.field(
                    Sensed(
                        replace(now, ranges=seen), twist, controller.twist_per_stick, (x, y, theta)
                    )
                )
            )
        device = stick.advance(hand)
        twist = controller.intent(device.position)
        speed += (1 - exp(-1 / 240 / 0.08)) * (twist.vx - speed)
        gap -= speed / 240
        gaps.append(gap)
    return np.array(gaps)
