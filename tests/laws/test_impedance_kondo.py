"""Kondo's impedance: eq. 1.4 by hand, and which obstacles lie in the recognition area."""

from __future__ import annotations

from math import cos, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.any_scene import scans, twists

from omnistudy.geometry import ZERO_MATRIX, ForceField, PlanarTwist, Scan
from omnistudy.laws import Sensed
from omnistudy.laws.impedance_kondo import ImpedanceKondoLaw
from omnistudy.laws.impedance_urbano import ImpedanceUrbanoLaw

LAW = ImpedanceKondoLaw(
    stiffness=10.0, damping=3.0, alpha=0.2, top_speed=0.5, half_length=0.4, half_width=0.3
)
FREE = 10 * (0.4 + 1.2)
"""N/m at 0.2 m/s where nothing counts: v/vmax = 0.4."""
NEAR = 10 * (4 * 0.6 + 1)
"""N/m at 0.2 m/s with an obstacle half-way to the circle of 0.5 m."""


def field(scan: Scan, twist: PlanarTwist) -> ForceField:
    return LAW.field(Sensed(scan, twist, ZERO_MATRIX))


def stiffness(scan: Scan, degrees: float, speed: float = 0.2) -> float:
    """K for a stick that asks for a way so many degrees to the left of ahead."""
    way = radians(degrees)
    return field(scan, PlanarTwist(speed * cos(way), speed * sin(way), 0.3)).stiffness[0][0]


def post(degrees: float, distance: float = 0.25) -> Scan:
    return Scan(np.array([radians(degrees)]), np.array([distance]), 0.6)


@pytest.mark.parametrize(
    ("way", "where", "counts"),
    [
        # Ahead the band is 0.3 m wide to each side, more than 0.25 m: all in front counts.
        (0, 0, True),
        (0, 89, True),
        (0, -89, True),
        (0, 91, False),
        (0, 180, False),
        (90, 90, True),
        (90, -90, False),
        (180, 180, True),
        (180, 0, False),
    ],
)
def test_what_lies_ahead_of_the_motion_counts(way: float, where: float, counts: bool) -> None:
    assert stiffness(post(where), way) == pytest.approx(NEAR if counts else FREE)


@pytest.mark.parametrize(
    ("way", "half_width"),
    [
        (0.0, 0.3),
        (90.0, 0.4),
        # The tangents of the ellipse along 45 degrees: sqrt((0.4² + 0.3²) / 2) = 0.25·sqrt(2).
        (45.0, 0.125**0.5),
        # Along (0.6, 0.8): sqrt((0.4·0.8)² + (0.3·0.6)²) = 0.36715.
        (53.13010235415598, 0.36715119501371637),
    ],
)
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_band_ends_at_the_tangents_of_the_ellipse(
    way: float, half_width: float, side: float
) -> None:
    def place(aside: float) -> Scan:
        """An obstacle 0.2 m along the way and so far beside it."""
        bearing = radians(way) + side * np.arctan2(aside, 0.2)
        return Scan(np.array([bearing]), np.array([np.hypot(aside, 0.2)]), 0.6)

    assert stiffness(place(half_width - 1e-6), way) > FREE + 0.5
    assert stiffness(place(half_width + 1e-6), way) == pytest.approx(FREE)


def test_the_nearest_in_the_area_is_what_counts() -> None:
    """0.2 m behind is nearer, but not on the way; 0.25 m ahead of 0.4 m is the nearest on it."""
    angles = np.array([pi, 0.1, -0.1])
    scan = Scan(angles, np.array([0.2, 0.25, 0.4]), 0.6)
    assert stiffness(scan, 0.0) == pytest.approx(NEAR)


def test_a_robot_that_goes_nowhere_has_no_way() -> None:
    turning = PlanarTwist(0.0, 0.0, 1.0)
    assert field(post(0), turning).stiffness[0][0] == pytest.approx(12.0)


def test_a_ray_that_starts_elsewhere_sees_where_its_obstacle_is() -> None:
    """From 0.35 m to the left straight ahead: outside the band of 0.3 m."""
    beside = Scan(np.array([0.0]), np.array([0.1]), 0.6, np.array([[0.0, 0.35]]))
    within = Scan(np.array([0.0]), np.array([0.1]), 0.6, np.array([[0.0, 0.25]]))
    assert stiffness(beside, 0.0) == pytest.approx(FREE)
    assert stiffness(within, 0.0) > FREE + 0.5


def test_the_damper_is_the_same_everywhere() -> None:
    for scan in (post(0), post(0, 0.55)):
        found = field(scan, PlanarTwist(0.2, 0.0, 0.0)).damping
        assert found == ((3.0, 0, 0), (0, 3.0, 0), (0, 0, 0))


@given(scans(), twists, st.floats(-0.04, 0.04), st.floats(-0.04, 0.04))
def test_what_is_mirrored_is_felt_mirrored(
    scan: Scan, twist: PlanarTwist, x: float, y: float
) -> None:
    here = LAW.field(Sensed(scan, twist, ZERO_MATRIX, (x, y, 0.2)))
    vx, vy, omega = twist
    flipped = PlanarTwist(vx, -vy, -omega)
    there = LAW.field(Sensed(scan.mirrored(), flipped, ZERO_MATRIX, (x, -y, -0.2)))
    fx, fy, tau = here.wrench
    assert there.wrench == pytest.approx((fx, -fy, -tau))
    assert (there.stiffness, there.damping) == (here.stiffness, here.damping)


@given(scans(), twists)
def test_it_is_never_stiffer_than_looking_all_round(scan: Scan, twist: PlanarTwist) -> None:
    """Urbano's law counts every obstacle."""
    all_round = ImpedanceUrbanoLaw(stiffness=10.0, damping=3.0, alpha=0.2, top_speed=0.5)
    sensed = Sensed(scan, twist, ZERO_MATRIX)
    assert field(scan, twist).stiffness[0][0] <= all_round.field(sensed).stiffness[0][0]
