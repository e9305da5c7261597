"""The quadrant law and its smoothed form: 0.10 m times the springs' force, one way or the other.

37.5 and 24 PWM per cm, 255 PWM are 13.5 N; the rectangle lies 0.44 m ahead and 0.31 m aside.
"""

from __future__ import annotations

from math import atan2, hypot, sin

import pytest
from hypothesis import given
from laws.any_scene import scans
from laws.straight_walls import few_rays, scan_of

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws.boundary import AnyBoundary, CircularBoundary, RectangularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.quadrant import QuadrantLaw
from omnistudy.laws.quadrant_smoothed import QuadrantSmoothedLaw
from omnistudy.laws.quadrants import ForceQuadrantLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
NEWTONS = 13.5 / 255
NEWTON_METRES = 4.4 / 255

DEEP = [((0.6, 0.8), 0.3125), ((0.6, -0.8), 0.3125), ((-0.6, 0.8), 0.3125), ((-0.6, -0.8), 0.3125)]
"""7.5 cm deep along a ray: the boundary is 0.31/0.8 away. 4.5 cm along x, 6 cm along y."""

FORCE = hypot(37.5 * 4.5, 24 * 6) * NEWTONS
SINE = 2 * (37.5 * 4.5) * (24 * 6) / ((37.5 * 4.5) ** 2 + (24 * 6) ** 2)

any_quadrant_law = pytest.mark.parametrize("law", [QuadrantLaw(), QuadrantSmoothedLaw()])
any_boundary = pytest.mark.parametrize("boundary", [RectangularBoundary(), CircularBoundary()])


@pytest.mark.parametrize(
    ("ray", "way"),
    [(DEEP[0], -1), (DEEP[1], 1), (DEEP[2], 1), (DEEP[3], -1)],
    ids=["ahead left", "ahead right", "behind left", "behind right"],
)
def test_the_robot_turns_away_from_what_is_in_a_quadrant(
    ray: tuple[tuple[float, float], float], way: int
) -> None:
    scan = few_rays([ray])
    assert QuadrantLaw().wrench(scan, STILL).tau == pytest.approx(way * 0.10 * FORCE)
    smoothed = QuadrantSmoothedLaw().wrench(scan, STILL).tau
    assert smoothed == pytest.approx(way * 0.10 * FORCE * SINE)


def test_arm_and_gain_are_factors() -> None:
    law = QuadrantLaw(arm=0.3, gain=2.0)
    assert law.wrench(few_rays([DEEP[1]]), STILL).tau == pytest.approx(0.6 * FORCE)


def test_over_a_circle() -> None:
    # 0.40 m off along (0.6, 0.8): 10 cm deep, 6 along x and 8 along y.
    force = hypot(37.5 * 6, 24 * 8) * NEWTONS
    law = QuadrantLaw(boundary=CircularBoundary())
    assert law.wrench(few_rays([((0.6, 0.8), 0.40)]), STILL).tau == pytest.approx(-0.10 * force)


@any_quadrant_law
@pytest.mark.parametrize("ray", [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)])
def test_a_force_along_an_axis_turns_nothing_and_rotation_is_not_damped(
    law: ForceQuadrantLaw, ray: tuple[float, float]
) -> None:
    wrench = law.wrench(few_rays([(ray, 0.25)]), PlanarTwist(0.0, 0.0, 0.7))
    assert wrench.tau == pytest.approx(0.0, abs=1e-12)


@any_quadrant_law
def test_rotation_is_damped_where_a_torque_is(law: ForceQuadrantLaw) -> None:
    scan = few_rays([DEEP[0]])
    loss = law.wrench(scan, PlanarTwist(0.0, 0.0, 0.5)).tau - law.wrench(scan, STILL).tau
    assert loss == pytest.approx(-12 * 0.5 * NEWTON_METRES)


def test_the_check_scene() -> None:
    """Spec 4.4: a slanted wall ahead on the left, six rays."""
    scan = scan_of([(1.0, 1.0, 0.65)])
    assert QuadrantLaw().wrench(scan, STILL) == pytest.approx((-5.52, -2.41, -0.60), abs=0.005)
    smoothed = QuadrantSmoothedLaw().wrench(scan, STILL)
    assert smoothed == pytest.approx((-5.52, -2.41, -0.44), abs=0.005)


def test_in_the_full_corner_it_still_turns_the_robot_out() -> None:
    """Spec 4.4: walls 0.38 m ahead and 0.25 m to the left."""
    wrench = QuadrantLaw().wrench(scan_of([(1.0, 0.0, 0.38), (0.0, 1.0, 0.25)]), STILL)
    assert wrench.tau == pytest.approx(-0.623, abs=0.0005)


@any_boundary
@given(scan=scans())
def test_the_torque_follows_the_springs_force_in_any_scene(
    boundary: AnyBoundary, scan: Scan
) -> None:
    fx, fy, tau = QuadrantLaw(boundary=boundary).wrench(scan, STILL)
    component = ComponentLaw(boundary=boundary).wrench(scan, STILL)
    smoothed = QuadrantSmoothedLaw(boundary=boundary).wrench(scan, STILL)
    assert (fx, fy) == (component.fx, component.fy) == (smoothed.fx, smoothed.fy)
    assert abs(tau) == pytest.approx(0.10 * hypot(fx, fy) if fx and fy else 0.0)
    assert tau * fx * fy <= 0.0
    assert smoothed.tau == pytest.approx(-0.10 * hypot(fx, fy) * sin(2 * atan2(fy, fx)), abs=1e-12)


def test_the_jump_that_the_sine_takes_away() -> None:
    """Something dead ahead that moves a millimetre from right to left."""
    right, left = ((1.0, -0.0025), 0.34), ((1.0, 0.0025), 0.34)
    jump = [QuadrantLaw().wrench(few_rays([ray]), STILL).tau for ray in (right, left)]
    assert jump == pytest.approx([0.10 * 375 * NEWTONS, -0.10 * 375 * NEWTONS], rel=1e-4)
    gentle = [QuadrantSmoothedLaw().wrench(few_rays([ray]), STILL).tau for ray in (right, left)]
    assert max(map(abs, gentle)) < 0.005 * jump[0]


def test_as_published_the_springs_are_rounded_and_the_torque_follows_them() -> None:
    # One ray, its own angle: 10 cm deep dead ahead but for 0.004 cm to the left, which rounds to 0.
    scan = few_rays([((1.0, 0.0004), 0.34)])
    assert QuadrantLaw().wrench(scan, STILL).tau < 0.0
    assert QuadrantLaw(as_published=True).wrench(scan, STILL).tau == 0.0
