"""Urbano's impedance, against eq. 1.4 worked out by hand on a circle of 0.5 m."""

from __future__ import annotations

from math import cos, isfinite, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.any_scene import scans, twists
from laws.straight_walls import few_rays, scan_of

from omnistudy.geometry import ZERO_MATRIX, ForceField, PlanarTwist, Scan, Vector3
from omnistudy.laws import Sensed
from omnistudy.laws.boundary import RectangularBoundary
from omnistudy.laws.impedance_urbano import ImpedanceUrbanoLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
AHEAD, LEFT = (1.0, 0.0), (0.0, 1.0)
LAW = ImpedanceUrbanoLaw(stiffness=10.0, damping=3.0, alpha=0.2, top_speed=0.5)


def field(
    scan: Scan, twist: PlanarTwist = STILL, stick: Vector3 = (0.0, 0.0, 0.0), law: object = LAW
) -> ForceField:
    assert isinstance(law, ImpedanceUrbanoLaw)
    return law.field(Sensed(scan, twist, ZERO_MATRIX, stick))


def k_of(scan: Scan, twist: PlanarTwist = STILL, law: object = LAW) -> float:
    return field(scan, twist, law=law).stiffness[0][0]


@pytest.mark.parametrize(
    ("distance", "speed", "stiffness"),
    [
        # r/rmax = 1/2: 10·(4·(v/vmax + 0.2) + 1)
        (0.25, 0.0, 18.0),
        (0.25, 0.25, 38.0),
        (0.25, 0.5, 58.0),
        # r/rmax = 4/5: 10·((v/vmax + 0.2)/0.64 + 1)
        (0.40, 0.0, 13.125),
        (0.40, 0.5, 28.75),
    ],
)
def test_the_formula(distance: float, speed: float, stiffness: float) -> None:
    scan = few_rays([(AHEAD, distance), (LEFT, 0.45)])
    assert k_of(scan, PlanarTwist(speed, 0.0, 0.0)) == pytest.approx(stiffness)


def test_speed_is_that_of_both_directions_and_turning_is_none() -> None:
    # (0.3, 0.4) m/s are 0.5 m/s.
    scan = few_rays([(AHEAD, 0.25)])
    assert k_of(scan, PlanarTwist(0.3, -0.4, 1.2)) == pytest.approx(58.0)
    assert k_of(scan, PlanarTwist(0.0, 0.0, 1.2)) == pytest.approx(18.0)


def test_the_hand_feels_minus_the_counter_torque_and_no_torque_about_the_stick() -> None:
    found = field(few_rays([(AHEAD, 0.25)]), STILL, (0.02, -0.01, 0.5))
    assert found.wrench == pytest.approx((-18.0 * 0.02, 18.0 * 0.01, 0.0))
    assert found.about == (0.02, -0.01, 0.5)
    assert found.stiffness == ((18.0, 0, 0), (0, 18.0, 0), (0, 0, 0))


def test_damping_keeps_its_share_of_critical() -> None:
    # K is 1.8·K0, so D is sqrt(1.8)·D0: D / sqrt(K) stays.
    d = 3.0 * sqrt(1.8)
    found = field(few_rays([(AHEAD, 0.25)])).damping
    assert np.array(found) == pytest.approx(np.diag([d, d, 0.0]))


@given(twists)
def test_without_obstacles_it_is_the_formula_at_the_greatest_range(twist: PlanarTwist) -> None:
    """K0·(v/vmax + alpha + 1): 12 N/m at rest, and no force on a stick in its zero."""
    found = field(scan_of([]), twist)
    speed = sqrt(twist.vx**2 + twist.vy**2)
    assert found.stiffness[0][0] == pytest.approx(10.0 * (speed / 0.5 + 1.2))
    assert found.wrench == (0.0, 0.0, 0.0)


def test_nothing_jumps_as_an_obstacle_comes_in() -> None:
    outside, inside = (k_of(few_rays([(AHEAD, at)])) for at in (0.5001, 0.4999))
    assert inside == pytest.approx(outside, rel=1e-3)
    assert inside > outside == 12.0


def test_on_a_rectangle_r_is_the_share_of_the_way_to_the_boundary() -> None:
    """0.31 m to the side: 0.155 m is half of it, though 0.20 m ahead of 0.44 m is less near."""
    law = LAW.model_copy(update={"boundary": RectangularBoundary()})
    assert k_of(few_rays([(AHEAD, 0.30), (LEFT, 0.155)]), law=law) == pytest.approx(18.0)


@given(scans(), twists, st.floats(0.01, 0.99))
def test_nearer_is_never_softer(scan: Scan, twist: PlanarTwist, share: float) -> None:
    nearer = Scan(scan.angles, scan.ranges * share, scan.max_range)
    assert k_of(nearer, twist) >= k_of(scan, twist) - 1e-9


@given(scans(), twists, st.floats(-3.0, 3.0))
def test_a_turned_scene_is_as_stiff(scan: Scan, twist: PlanarTwist, angle: float) -> None:
    vx, vy, omega = twist
    turned = Scan(scan.angles + angle, scan.ranges, scan.max_range)
    c, s = cos(angle), sin(angle)
    there = k_of(turned, PlanarTwist(c * vx - s * vy, s * vx + c * vy, omega))
    assert there == pytest.approx(k_of(scan, twist))


@pytest.mark.parametrize("distance", [5e-324, 1e-9, 0.1])
def test_stiffness_has_a_most(distance: float) -> None:
    # r/rmax counts as 0.38 at least: 10·(0.2 / 0.1444 + 1).
    k = k_of(few_rays([(AHEAD, distance)]))
    assert isfinite(k)
    assert k == pytest.approx(10 * (0.2 / 0.1444 + 1))


def test_no_stiffness_leaves_the_damper() -> None:
    law = ImpedanceUrbanoLaw(stiffness=0.0, damping=3.0)
    found = field(few_rays([(AHEAD, 0.25)]), law=law)
    assert (found.stiffness[0][0], found.damping[0][0]) == (0.0, 3.0)
