"""The natural law, against arithmetic done by hand in the thesis's own units.

37.5 and 24 PWM per cm; eq. 4.5 multiplies both forces by 315/24 PWM per PWM·m. 255 PWM are 13.5 N
or 4.4 N·m. The rectangle lies 0.44 m ahead and 0.31 m aside, the circle 0.5 m all round.
"""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.any_scene import scans
from laws.straight_walls import few_rays, scan_of

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws.boundary import AnyBoundary, CircularBoundary, RectangularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.spring_damper import MomentStiffness, SpringDamperLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
NEWTONS = 13.5 / 255
NEWTON_METRES = 4.4 / 255
TURN = 315 / 24

AHEAD, LEFT, AHEAD_LEFT = (1.0, 0.0), (0.0, 1.0), (0.8, 0.6)
any_boundary = pytest.mark.parametrize("boundary", [RectangularBoundary(), CircularBoundary()])


def test_the_published_numbers() -> None:
    """Spec 4.4: 849.3 and 543.5 N·m/m²."""
    stiffness = SpringDamperLaw().stiffness
    assert stiffness.theta_x == pytest.approx(849.3, abs=0.05)
    assert stiffness.theta_y == pytest.approx(543.5, abs=0.05)


@pytest.mark.parametrize("centre", [0.0, 0.1, -0.2])
def test_both_springs_turn_the_robot_about_the_centre(centre: float) -> None:
    # A ray along (0.8, 0.6) meets something at 0.50 m, at (0.40, 0.30): the boundary is 0.31/0.6
    # away, so it is 5/3 cm deep, 4/3 cm along x and 1 cm along y.
    law = SpringDamperLaw(compliance_centre=centre)
    wrench = law.wrench(few_rays([(AHEAD, 0.40), (AHEAD_LEFT, 0.50)]), STILL)
    fx, fy = -37.5 * 4 / 3 / 2, -24 * 1 / 2
    assert wrench.fx == pytest.approx((fx - 37.5 * 4 / 2) * NEWTONS)
    assert wrench.fy == pytest.approx(fy * NEWTONS)
    # r x F of that ray alone, the one dead ahead having neither arm nor force across.
    moment = (0.40 - centre) * fy - 0.30 * fx
    assert wrench.tau == pytest.approx(TURN * moment * NEWTON_METRES)


def test_over_a_circle() -> None:
    # 0.40 m dead ahead: 10 cm deep. At (0.24, 0.32), 0.40 m off: 10 cm, of which 6 and 8.
    law = SpringDamperLaw(boundary=CircularBoundary())
    wrench = law.wrench(few_rays([(AHEAD, 0.40), ((0.6, 0.8), 0.40)]), STILL)
    assert wrench.fx == pytest.approx(-37.5 * (10 + 6) / 2 * NEWTONS)
    assert wrench.fy == pytest.approx(-24 * 8 / 2 * NEWTONS)
    moment = 0.24 * (-24 * 8 / 2) - 0.32 * (-37.5 * 6 / 2)
    assert wrench.tau == pytest.approx(TURN * moment * NEWTON_METRES)


def test_the_moment_is_of_the_point_that_the_ray_meets() -> None:
    # From (0.20, 0.10) along (0.8, 0.6): 0.24/0.8 = 0.30 m to the boundary, met at 0.25 m, 5 cm
    # deep (4 and 3), at (0.40, 0.25).
    angle = np.array([np.arctan2(0.6, 0.8)])
    scan = Scan(angle, np.array([0.25]), 0.6, np.array([[0.20, 0.10]]))
    moment = 0.40 * (-24 * 3) - 0.25 * (-37.5 * 4)
    assert SpringDamperLaw().wrench(scan, STILL).tau == pytest.approx(TURN * moment * NEWTON_METRES)


def test_the_check_scene_turns_the_robot_into_the_wall() -> None:
    """Spec 4.4: a slanted wall ahead on the left, six rays."""
    wrench = SpringDamperLaw().wrench(scan_of([(1.0, 1.0, 0.65)]), STILL)
    assert wrench == pytest.approx((-5.52, -2.41, 2.23), abs=0.005)


def test_the_full_corner() -> None:
    """Spec 4.4: walls 0.38 m ahead and 0.25 m to the left."""
    wrench = SpringDamperLaw().wrench(scan_of([(1.0, 0.0, 0.38), (0.0, 1.0, 0.25)]), STILL)
    assert wrench.tau == pytest.approx(-0.144, abs=0.0005)


@any_boundary
@given(scan=scans())
def test_the_torque_is_minus_nine_sixteenths_of_the_component_laws(
    boundary: AnyBoundary, scan: Scan
) -> None:
    """Spec 4.4, in any scene with c = 0: -(37.5/24 - 1), to 1e-9 of the largest moment there."""
    natural = SpringDamperLaw(boundary=boundary).wrench(scan, STILL)
    component = ComponentLaw(boundary=boundary).wrench(scan, STILL)
    inside = boundary.penetrations(scan)
    largest = 0.0 if inside is None else 849.3 * float((inside.depth * inside.distance).max())
    assert natural.tau == pytest.approx(-0.5625 * component.tau, rel=1e-9, abs=1e-9 * largest)
    assert (natural.fx, natural.fy) == (component.fx, component.fy)


@given(scan=scans(), kx=st.floats(50.0, 500.0), ky=st.floats(50.0, 500.0))
def test_with_other_gains_it_is_what_the_ratio_says(scan: Scan, kx: float, ky: float) -> None:
    moments = MomentStiffness(theta_x=543.5 * kx / ky, theta_y=543.5)
    natural = SpringDamperLaw(stiffness=moments).wrench(scan, STILL)
    component = ComponentLaw.model_validate({"stiffness": {"theta": 543.5}}).wrench(scan, STILL)
    assert natural.tau == pytest.approx(-(kx / ky - 1) * component.tau, rel=1e-9, abs=1e-9)


@any_boundary
@given(scan=scans(), twist_rate=st.floats(-1.2, 1.2))
def test_with_equal_gains_radial_springs_turn_nothing_and_nothing_is_damped(
    boundary: AnyBoundary, scan: Scan, twist_rate: float
) -> None:
    equal = MomentStiffness(theta_x=500.0, theta_y=500.0)
    law = SpringDamperLaw(boundary=boundary, stiffness=equal)
    assert law.wrench(scan, PlanarTwist(0.0, 0.0, twist_rate)).tau == 0.0


def test_rotation_is_damped_where_a_torque_is() -> None:
    law, scan = SpringDamperLaw(), scan_of([(1.0, 1.0, 0.65)])
    turning = law.wrench(scan, PlanarTwist(0.0, 0.0, 0.5)).tau
    assert turning - law.wrench(scan, STILL).tau == pytest.approx(-12 * 0.5 * NEWTON_METRES)
    ahead = few_rays([(AHEAD, 0.40)])
    assert law.wrench(ahead, PlanarTwist(0.0, 0.0, 0.5)).tau == 0.0


def test_as_published_its_moments_are_rounded_to_hundredths_of_cm_metres() -> None:
    # One ray, and so its own angle: at 0.4911 m along (0.8, 0.6), at (0.3929, 0.2947), it is
    # 2.5567 cm deep, 2.0453 and 1.5340: both moments are 0.6027 cm·m and count as 0.60.
    scan = few_rays([(AHEAD_LEFT, 0.4911)])
    exact = SpringDamperLaw().wrench(scan, STILL).tau
    rounded = SpringDamperLaw(as_published=True).wrench(scan, STILL).tau
    assert exact == pytest.approx(315 * (37.5 / 24 - 1) * 0.6027 * NEWTON_METRES, rel=1e-4)
    assert rounded == pytest.approx(315 * (37.5 / 24 - 1) * 0.60 * NEWTON_METRES)
