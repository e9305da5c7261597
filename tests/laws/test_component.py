"""The component law, against arithmetic done by hand in the thesis's own units.

37.5 and 24 PWM per cm, 315 PWM per cm·m; 255 PWM are 13.5 N or 4.4 N·m. The boundary
lies 0.44 m ahead and 0.31 m aside.
"""

from __future__ import annotations

from math import sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.any_scene import reach, scans
from laws.straight_walls import few_rays, scan_of

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws.boundary import CircularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.zero_torque import ZeroTorqueLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
NEWTONS = 13.5 / 255
NEWTON_METRES = 4.4 / 255

AHEAD, LEFT = (1.0, 0.0), (0.0, 1.0)
AHEAD_LEFT, AHEAD_RIGHT = (0.8, 0.6), (0.8, -0.6)

WALL_AHEAD = (1.0, 0.0, 0.40)
"""At 0.40 m: 4 cm deep dead ahead. Along (0.8, ±0.6) the boundary is 0.31 / 0.6 = 51 2/3 cm away
and the wall 50 cm: 5/3 cm deep, of which 4/3 cm lie along x and 1 cm along y."""


def test_a_wall_ahead_pushes_straight_back() -> None:
    scan = few_rays([(AHEAD_RIGHT, 0.50), (AHEAD, 0.40), (AHEAD_LEFT, 0.50)])
    wrench = ComponentLaw().wrench(scan, STILL)
    assert wrench.fx == pytest.approx(-37.5 * (4 / 3 + 4 + 4 / 3) / 3 * NEWTONS)
    assert wrench.fx == pytest.approx(-4.4118, abs=1e-4)
    assert (wrench.fy, wrench.tau) == (0.0, 0.0)


@pytest.mark.parametrize(("centre", "arm"), [(0.0, 0.4), (0.1, 0.3), (-0.1, 0.5), (0.4, 0.0)])
def test_what_is_ahead_on_the_left_pushes_right_and_turns_clockwise(
    centre: float, arm: float
) -> None:
    scan = few_rays([(AHEAD, 0.40), (AHEAD_LEFT, 0.50)])
    wrench = ComponentLaw(compliance_centre=centre).wrench(scan, STILL)
    assert wrench.fx == pytest.approx(-37.5 * (4 + 4 / 3) / 2 * NEWTONS)
    assert wrench.fy == pytest.approx(-24 * 1 / 2 * NEWTONS)
    assert wrench.tau == pytest.approx(-315 * 1 * arm / 2 * NEWTON_METRES, abs=1e-12)


@given(scan=scans(), centre=st.floats(-0.3, 0.3))
def test_a_centre_ahead_adds_its_arm_times_the_sideways_mean(scan: Scan, centre: float) -> None:
    """tau(c) - tau(0) = ktheta·c·mean(py): moving ahead, what lies left turns less clockwise."""
    moved = ComponentLaw(compliance_centre=centre).wrench(scan, STILL)
    middle = ComponentLaw().wrench(scan, STILL)
    sideways = [
        (reach(angle) - distance) * sin(angle)
        for angle, distance in zip(scan.angles, scan.ranges, strict=True)
        if distance < reach(angle) and distance < scan.max_range
    ]
    mean = sum(sideways) / len(sideways) if sideways else 0.0
    stiffness = 315 * 100 * NEWTON_METRES
    assert moved.tau - middle.tau == pytest.approx(stiffness * centre * mean, abs=1e-8)
    assert (moved.fx, moved.fy) == (middle.fx, middle.fy)


def test_a_wall_on_the_left_pushes_right() -> None:
    # At 0.25 m: 6 cm deep square on; along (±0.6, 0.8) 0.31 / 0.8 - 0.25 / 0.8 = 7.5 cm.
    scan = few_rays([((0.6, 0.8), 0.3125), (LEFT, 0.25), ((-0.6, 0.8), 0.3125)])
    wrench = ComponentLaw().wrench(scan, STILL)
    assert wrench.fy == pytest.approx(-24 * (6 + 6 + 6) / 3 * NEWTONS)
    assert (wrench.fx, wrench.tau) == (0.0, 0.0)


def test_a_wall_beside_the_front_turns_away_from_it() -> None:
    scan = few_rays([((0.6, 0.8), 0.3125), (LEFT, 0.25)])
    wrench = ComponentLaw().wrench(scan, STILL)
    assert wrench.fx == pytest.approx(-37.5 * 4.5 / 2 * NEWTONS)
    assert wrench.fy == pytest.approx(-24 * (6 + 6) / 2 * NEWTONS)
    assert wrench.tau == pytest.approx(-315 * 6 * 0.1875 / 2 * NEWTON_METRES)


@pytest.mark.parametrize(("law", "turns"), [(ComponentLaw, True), (ZeroTorqueLaw, False)])
def test_over_a_circle(law: type[ComponentLaw] | type[ZeroTorqueLaw], turns: bool) -> None:
    # 0.40 m dead ahead: 10 cm inside 0.50 m. At (0.24, 0.32), 0.40 m off: 10 cm, of which 6 and 8.
    scan = few_rays([(AHEAD, 0.40), ((0.6, 0.8), 0.40)])
    wrench = law(boundary=CircularBoundary()).wrench(scan, STILL)
    assert wrench.fx == pytest.approx(-37.5 * (10 + 6) / 2 * NEWTONS)
    assert wrench.fy == pytest.approx(-24 * 8 / 2 * NEWTONS)
    assert wrench.tau == pytest.approx(-315 * 8 * 0.24 / 2 * NEWTON_METRES if turns else 0.0)


def test_the_check_scene() -> None:
    """Spec 4.4: a slanted wall ahead on the left, six rays."""
    law = ComponentLaw()
    scan = scan_of([(1.0, 1.0, 0.65)])
    touching = law.touching(scan)
    assert touching is not None
    assert touching.rays.size == 6
    assert law.wrench(scan, STILL) == pytest.approx((-5.52, -2.41, -3.97), abs=0.005)


def test_in_a_full_corner_the_torque_points_into_it() -> None:
    """Spec 4.4: the far rays of the left wall turn the robot back."""
    wrench = ComponentLaw().wrench(scan_of([(1.0, 0.0, 0.38), (0.0, 1.0, 0.25)]), STILL)
    assert wrench.tau == pytest.approx(0.257, abs=0.0005)
    assert wrench.fx < 0.0
    assert wrench.fy < 0.0


def test_the_middle_of_a_corridor_is_free_of_force() -> None:
    scan = scan_of([(0.0, 1.0, 0.25), (0.0, -1.0, 0.25)])
    assert ComponentLaw().touching(scan) is not None
    assert ComponentLaw().wrench(scan, PlanarTwist(0.3, 0.3, 0.8)) == (0.0, 0.0, 0.0)


def test_a_wall_that_only_grazes_weakens_a_post() -> None:
    """Spec 11: the mean is over the rays that touch, here one, then thirty-eight."""
    post = few_rays([(AHEAD, 0.34)])
    assert ComponentLaw().wrench(post, STILL).fx == pytest.approx(-375 * NEWTONS)
    grazing = scan_of([(0.0, 1.0, 0.309)], max_range=0.5)
    ranges = np.where(grazing.angles == 0.0, 0.34, grazing.ranges)
    both = ComponentLaw().wrench(Scan(grazing.angles, ranges, 0.5), STILL)
    assert both.fx == pytest.approx(-375 / 38 * NEWTONS, rel=1e-6)
    assert both.fx == pytest.approx(-9.9 * NEWTONS, rel=0.005)


def test_an_axis_is_damped_only_where_its_spring_pushes() -> None:
    twist = PlanarTwist(0.2, -0.1, 0.5)
    ahead = ComponentLaw().wrench(few_rays([(AHEAD, 0.40)]), twist)
    assert ahead.fx == pytest.approx((-37.5 * 4 - 15 * 0.2) * NEWTONS)
    assert (ahead.fy, ahead.tau) == (0.0, 0.0)
    corner = ComponentLaw().wrench(few_rays([(AHEAD, 0.40), (AHEAD_LEFT, 0.50)]), twist)
    assert corner.fy == pytest.approx((-24 / 2 + 90 * 0.1) * NEWTONS)
    assert corner.tau == pytest.approx((-315 * 0.4 / 2 - 12 * 0.5) * NEWTON_METRES)


@pytest.mark.parametrize("distance", [0.39, 0.40, 0.43])
def test_at_its_greatest_range_a_sensor_sees_nothing(distance: float) -> None:
    scan = few_rays([(AHEAD, distance)], max_range=0.39)
    assert ComponentLaw().wrench(scan, PlanarTwist(0.3, 0.3, 0.8)) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("published", [False, True])
def test_free_space_gives_exact_zeros(published: bool) -> None:
    scan = scan_of([])
    law = ComponentLaw(as_published=published)
    values = np.array(law.wrench(scan, PlanarTwist(0.36, -0.36, 1.2)))
    assert values.tobytes() == np.zeros(3).tobytes()
