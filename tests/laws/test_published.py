"""As published: the angle of the ray before, two decimals, a far clip of 0.5 m."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest
from laws.straight_walls import RAYS, few_rays, scan_of

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws import published
from omnistudy.laws.component import ComponentLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
NEWTONS = 13.5 / 255
NEWTON_METRES = 4.4 / 255
PUBLISHED = ComponentLaw(as_published=True)


def test_a_wall_dead_ahead_gets_a_sideways_force_and_a_torque() -> None:
    """Analysis C4 in PWM: -278, +8.7, and -34 clockwise, so +34 here; the wall is at 0.36 m."""
    wrench = PUBLISHED.wrench(scan_of([(1.0, 0.0, 0.36)]), STILL)
    assert wrench.fx / NEWTONS == pytest.approx(-278, abs=0.5)
    assert wrench.fy / NEWTONS == pytest.approx(8.7, abs=0.1)
    assert wrench.tau / NEWTON_METRES == pytest.approx(34, abs=1.0)


def test_the_corrected_law_only_pushes_back() -> None:
    wrench = ComponentLaw().wrench(scan_of([(1.0, 0.0, 0.36)]), STILL)
    assert wrench.fx / NEWTONS == pytest.approx(-278, abs=0.5)
    assert (wrench.fy, wrench.tau) == (0.0, 0.0)


def test_a_ray_is_resolved_with_the_angle_of_the_ray_before() -> None:
    # Ray 64 looks dead ahead, is 7 cm deep, and is resolved as if it looked 2.8125 deg right.
    ranges = np.full(128, 0.6)
    ranges[64] = 0.37
    step = pi / 64
    wrench = PUBLISHED.wrench(Scan(np.array(RAYS), ranges, 0.6), STILL)
    assert 7 * cos(step) == pytest.approx(6.99, abs=0.005)
    assert 7 * sin(step) == pytest.approx(0.34, abs=0.005)
    assert 7 * sin(step) * 0.37 * cos(step) == pytest.approx(0.13, abs=0.005)
    assert wrench.fx == pytest.approx(-37.5 * 6.99 * NEWTONS)
    assert wrench.fy == pytest.approx(24 * 0.34 * NEWTONS)
    assert wrench.tau == pytest.approx(315 * 0.13 * NEWTON_METRES)


def test_the_ray_before_the_first_looks_one_step_farther_back() -> None:
    before = published.previous_angles(np.array(RAYS))
    assert before[0] == pytest.approx(-pi - pi / 64)
    assert before[1:].tolist() == list(RAYS[:-1])


def test_a_ray_alone_has_none_before() -> None:
    assert published.previous_angles(np.array([0.3])).tolist() == [0.3]


def test_means_are_rounded_to_hundredths_of_a_centimetre() -> None:
    # One ray, and so its own angle: 4.567 cm deep counts as 4.57.
    scan = few_rays([((1.0, 0.0), 0.39433)])
    assert PUBLISHED.wrench(scan, STILL).fx == pytest.approx(-37.5 * 4.57 * NEWTONS)
    assert ComponentLaw().wrench(scan, STILL).fx == pytest.approx(-37.5 * 4.567 * NEWTONS)


def test_what_rounds_to_nothing_is_not_damped() -> None:
    scan = few_rays([((1.0, 0.0), 0.43996)])
    twist = PlanarTwist(0.3, 0.0, 0.0)
    assert PUBLISHED.wrench(scan, twist) == (0.0, 0.0, 0.0)
    assert ComponentLaw().wrench(scan, twist).fx == pytest.approx(-(37.5 * 0.004 + 4.5) * NEWTONS)


def test_velocities_are_rounded_to_hundredths() -> None:
    scan = few_rays([((1.0, 0.0), 0.40)])
    spring = -37.5 * 4
    for given, counted in ((0.234, 0.23), (0.236, 0.24), (-0.236, -0.24)):
        fx = PUBLISHED.wrench(scan, PlanarTwist(given, 0.0, 0.0)).fx
        assert fx == pytest.approx((spring - 15 * counted) * NEWTONS)


@pytest.mark.parametrize(
    ("twist", "rounded"),
    [
        # Eighths are exact in binary, so 0.125 is a half: up, and in omega up clockwise.
        (PlanarTwist(0.125, -0.125, 0.125), (0.13, -0.12, 0.12)),
        (PlanarTwist(-0.125, 0.125, -0.125), (-0.12, 0.13, -0.13)),
        (PlanarTwist(0.1234, 0.1266, -0.1266), (0.12, 0.13, -0.13)),
    ],
)
def test_halves_go_up(twist: PlanarTwist, rounded: tuple[float, float, float]) -> None:
    assert published.rounded_twist(twist) == pytest.approx(rounded)


def test_the_corners_of_the_boundary_are_cut_off() -> None:
    # 13 steps from ahead, 36.6 deg: the boundary is 0.31 / sin = 0.520 m away.
    corner = 13 * pi / 64
    assert 0.31 / sin(corner) == pytest.approx(0.520, abs=0.0005)
    scan = few_rays([((cos(corner), sin(corner)), 0.51)])
    assert PUBLISHED.touching(scan) is None
    assert PUBLISHED.wrench(scan, STILL) == (0.0, 0.0, 0.0)
    depth = 31 / sin(corner) - 51
    assert ComponentLaw().wrench(scan, STILL).fx == pytest.approx(
        -37.5 * depth * cos(corner) * NEWTONS
    )
    nearer = few_rays([((cos(corner), sin(corner)), 0.499)])
    assert PUBLISHED.touching(nearer) is not None


def test_a_shorter_sensor_stays_shorter() -> None:
    assert PUBLISHED.touching(few_rays([((1.0, 0.0), 0.40)], max_range=0.40)) is None
