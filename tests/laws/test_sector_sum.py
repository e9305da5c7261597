"""The law of sixteen ultrasonic sectors, against eq. 1.8-1.9 worked out by hand."""

from __future__ import annotations

from math import cos, hypot, isfinite, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.any_scene import scans, twists
from laws.straight_walls import scan_of
from pydantic import ValidationError

from omnistudy.geometry import PlanarTwist, PlanarWrench, Scan
from omnistudy.laws.boundary import CircularBoundary, RectangularBoundary
from omnistudy.laws.sector_sum import SectorSumLaw

STILL = PlanarTwist(0.0, 0.0, 0.0)
LAW = SectorSumLaw(weights=(1.0,) * 16)


def seen(*rays: tuple[float, float]) -> Scan:
    """A scan of rays (degrees, m)."""
    return Scan(
        np.array([radians(angle) for angle, _ in rays]), np.array([far for _, far in rays]), 0.6
    )


@pytest.mark.parametrize(
    ("angle", "force"),
    [(0, (-4, 0)), (90, (0, -4)), (180, (4, 0)), (-90, (0, 4)), (45, (-4 * 0.5**0.5,) * 2)],
)
def test_one_obstacle_pushes_straight_away(angle: float, force: tuple[float, float]) -> None:
    # 1 N·m over 0.25 m.
    assert LAW.wrench(seen((angle, 0.25)), STILL) == pytest.approx((*force, 0.0), abs=1e-12)


def test_a_sector_takes_its_nearest_and_pushes_along_its_middle() -> None:
    # 5 and -8 degrees lie in the sector ahead, of which 0.2 m is the nearest: 5 N.
    scan = seen((5, 0.4), (-8, 0.2), (0, 0.45))
    assert LAW.wrench(scan, STILL) == pytest.approx((-5.0, 0.0, 0.0))


def test_sectors_add_up() -> None:
    # Ahead 1 / 0.25, left 1 / 0.5 and back 1 / 0.4 (on the boundary would be none).
    scan = seen((0, 0.25), (90, 0.4), (180, 0.4))
    assert LAW.wrench(scan, STILL) == pytest.approx((-4.0 + 2.5, -2.5, 0.0))


def test_each_sector_has_its_weight() -> None:
    # The fifth looks left: three times as strong; the first looks ahead: silent.
    law = SectorSumLaw(weights=(0, 1, 1, 1, 3, *[1] * 11))
    assert law.wrench(seen((0, 0.25), (90, 0.4)), STILL) == pytest.approx((0.0, -7.5, 0.0))


def test_what_lies_between_two_sectors_is_seen_by_both() -> None:
    # 11.25 degrees: 4 N ahead and 4 N along 22.5 degrees.
    wrench = LAW.wrench(seen((11.25, 0.25)), STILL)
    assert wrench == pytest.approx((-4 - 4 * cos(pi / 8), -4 * sin(pi / 8), 0.0))


def test_a_range_is_taken_from_the_robots_centre() -> None:
    """A sensor 0.2 m ahead that looks left and sees 0.2 m: the obstacle is 0.2·sqrt(2) m away."""
    scan = Scan(np.array([pi / 2]), np.array([0.2]), 0.6, np.array([[0.2, 0.0]]))
    each = -1 / (0.2 * 2**0.5) * 0.5**0.5
    assert LAW.wrench(scan, STILL) == pytest.approx((each, each, 0.0))


def test_the_default_weights_before_a_wall_that_the_published_robot_touches() -> None:
    """0.29 m ahead; nearest rays at 0, 11.25 and 33.75 degrees: 1/0.29 = 3.448, and twice
    cos 11.25 / 0.29 · cos 22.5 = 3.125 and cos 33.75 / 0.29 · cos 45 = 2.027; halved 6.88 N."""
    fx, fy, tau = SectorSumLaw().wrench(scan_of([(1.0, 0.0, 0.29)]), STILL)
    assert fx == pytest.approx(-0.5 * (3.448 + 2 * 3.125 + 2 * 2.027), abs=0.002)
    assert (fy, tau) == pytest.approx((0.0, 0.0), abs=1e-9)


@given(st.floats(0.21, 0.49), st.floats(0.001, 0.2))
def test_nearer_pushes_harder(distance: float, nearer: float) -> None:
    far, near = (
        LAW.wrench(scan_of([(1.0, 0.0, at)]), STILL).fx for at in (distance, distance - nearer)
    )
    assert near < far < 0.0


@given(st.integers(0, 15), scans())
def test_what_turns_by_a_sector_turns_the_force(sectors: int, scan: Scan) -> None:
    angle = sectors * pi / 8
    fx, fy, tau = LAW.wrench(scan, STILL)
    turned = LAW.wrench(Scan(scan.angles + angle, scan.ranges, scan.max_range), STILL)
    expected = (fx * cos(angle) - fy * sin(angle), fx * sin(angle) + fy * cos(angle), tau)
    assert turned == pytest.approx(expected, abs=1e-9)


@given(scans(), twists)
def test_how_the_stick_moves_is_nothing(scan: Scan, twist: PlanarTwist) -> None:
    assert LAW.wrench(scan, twist) == LAW.wrench(scan, STILL)


def test_only_what_is_inside_the_boundary_pushes() -> None:
    law = SectorSumLaw(boundary=RectangularBoundary(), weights=(1.0,) * 16)
    assert law.wrench(seen((0, 0.43), (90, 0.32)), STILL) == pytest.approx((-1 / 0.43, 0.0, 0.0))
    nothing = np.array(law.wrench(seen((0, 0.45), (90, 0.32)), PlanarTwist(0.3, 0.3, 1.0)))
    assert nothing.tobytes() == np.zeros(3).tobytes()


@pytest.mark.parametrize("distance", [5e-324, 1e-300, 1e-9, float("nan"), 0.0])
def test_the_force_is_finite_whatever_a_sensor_tells(distance: float) -> None:
    """Nothing counts as nearer than 0.02 m: 16 sectors of 0.5 / 0.02 = 25 N at the very most."""
    wrench = SectorSumLaw().wrench(seen((10, distance), (50, 0.3)), STILL)
    assert all(isfinite(part) for part in wrench)
    assert hypot(wrench.fx, wrench.fy) <= 16 * 25.0


def test_it_wants_sixteen_weights() -> None:
    with pytest.raises(ValidationError, match="16"):
        SectorSumLaw(weights=(1.0,) * 15)
    assert SectorSumLaw(boundary=CircularBoundary(radius=0.3)).wrench(
        seen((0, 0.35)), STILL
    ) == PlanarWrench(0.0, 0.0, 0.0)
