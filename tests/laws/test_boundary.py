"""The rectangle around the robot, 0.44 m ahead and behind and 0.31 m aside; and the circle."""

from __future__ import annotations

from math import cos, inf, nan, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from laws.straight_walls import RAYS
from pydantic import ValidationError

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws.boundary import Boundary, CircularBoundary, RectangularBoundary
from omnistudy.laws.component import ComponentLaw

REACH = RectangularBoundary().reach(np.array(RAYS))

AHEAD_OR_BEHIND = [*range(13), *range(52, 77), *range(116, 128)]
ASIDE = [*range(13, 52), *range(77, 116)]
"""The thesis's code lists these rays (appendix B): 0-12, 52-76, 116-127 and 13-51, 77-115."""


@pytest.mark.parametrize(
    ("cosine", "sine", "reach"),
    [
        (1.0, 0.0, 0.44),
        (-1.0, 0.0, 0.44),
        (0.0, 1.0, 0.31),
        (0.0, -1.0, 0.31),
        (0.6, 0.8, 0.3875),
        (-0.6, -0.8, 0.3875),
        (0.8, 0.6, 0.31 / 0.6),
        (12 / 13, -5 / 13, 0.44 * 13 / 12),
        (0.44, 0.31, (0.44**2 + 0.31**2) ** 0.5),
    ],
)
def test_reach_by_hand(cosine: float, sine: float, reach: float) -> None:
    angle = np.array([np.arctan2(sine, cosine)])
    assert RectangularBoundary().reach(angle)[0] == pytest.approx(reach)


def test_the_corner_is_farther_than_the_published_clip() -> None:
    corner = RectangularBoundary().reach(np.array([np.arctan2(0.31, 0.44)]))[0]
    assert corner == pytest.approx(0.538, abs=0.0005)


def test_the_published_rays_end_ahead_behind_or_aside() -> None:
    assert sorted(AHEAD_OR_BEHIND + ASIDE) == list(range(128))
    x, y = np.abs(REACH * np.cos(RAYS)), np.abs(REACH * np.sin(RAYS))
    assert x[AHEAD_OR_BEHIND] == pytest.approx(0.44)
    assert (y[AHEAD_OR_BEHIND] < 0.31).all()
    assert y[ASIDE] == pytest.approx(0.31)
    assert (x[ASIDE] < 0.44).all()


def test_layers_and_outline_add_up() -> None:
    boundary = RectangularBoundary(half_length=1.0, layer_x=0.5, half_width=0.7, layer_y=0.0)
    assert boundary.reach(np.array([0.0, pi / 2])) == pytest.approx([1.5, 0.7])


def test_penetrations_are_measured_along_the_ray() -> None:
    scan = Scan(np.array([0.0, pi / 2, pi, -pi / 2]), np.array([0.40, 0.31, 0.10, 0.30]), 0.6)
    found = RectangularBoundary().penetrations(scan)
    assert found is not None
    assert found.rays.tolist() == [0, 2, 3]
    assert found.depth == pytest.approx([0.04, 0.34, 0.01])
    assert found.distance.tolist() == [0.40, 0.10, 0.30]


@pytest.mark.parametrize("no_range", [nan, -0.1, -inf, 0.0, inf, 0.6, 0.44])
def test_what_is_no_distance_inside_is_no_detection(no_range: float) -> None:
    alone = Scan(np.array([0.0]), np.array([no_range]), 0.6)
    assert RectangularBoundary().penetrations(alone) is None
    beside_one = Scan(np.array([0.0, pi]), np.array([no_range, 0.40]), 0.6)
    found = RectangularBoundary().penetrations(beside_one)
    assert found is not None
    assert found.rays.tolist() == [1]


@pytest.mark.parametrize(("max_range", "seen"), [(0.41, True), (0.40, False), (0.39, False)])
def test_a_range_at_or_beyond_the_greatest_is_no_detection(max_range: float, seen: bool) -> None:
    scan = Scan(np.array([0.0]), np.array([0.40]), max_range)
    assert (RectangularBoundary().penetrations(scan) is not None) == seen


def test_a_scan_without_rays_holds_nothing() -> None:
    assert RectangularBoundary().penetrations(Scan(np.array([]), np.array([]), 0.6)) is None


any_boundary = pytest.mark.parametrize("boundary", [RectangularBoundary(), CircularBoundary()])
SAFE = 0.30
"""m from the centre in x and y that both boundaries enclose."""


def test_the_circle_is_as_far_all_round() -> None:
    assert CircularBoundary().reach(np.array(RAYS)).tolist() == [0.5] * 128
    assert CircularBoundary(radius=0.7).reach(np.array([1.0])).tolist() == [0.7]


@pytest.mark.parametrize(
    ("boundary", "origin", "ray", "reach"),
    [
        # From (0.20, 0.10) 0.24 m are left ahead, 0.64 behind, 0.21 to the left, 0.41 right.
        (RectangularBoundary(), (0.20, 0.10), (1.0, 0.0), 0.24),
        (RectangularBoundary(), (0.20, 0.10), (-1.0, 0.0), 0.64),
        (RectangularBoundary(), (0.20, 0.10), (0.6, 0.8), 0.21 / 0.8),
        (RectangularBoundary(), (0.20, 0.10), (0.8, -0.6), 0.24 / 0.8),
        (RectangularBoundary(), (-0.20, -0.10), (-0.8, 0.6), 0.24 / 0.8),
        # From (0.3, 0) the circle of 0.5 m has 3-4-5 to the side.
        (CircularBoundary(), (0.3, 0.0), (1.0, 0.0), 0.2),
        (CircularBoundary(), (0.3, 0.0), (-1.0, 0.0), 0.8),
        (CircularBoundary(), (0.3, 0.0), (0.0, 1.0), 0.4),
        (CircularBoundary(), (0.0, -0.3), (1.0, 0.0), 0.4),
    ],
)
def test_reach_from_off_the_centre_by_hand(
    boundary: Boundary, origin: tuple[float, float], ray: tuple[float, float], reach: float
) -> None:
    found = boundary.reach(np.array([np.arctan2(ray[1], ray[0])]), np.array([origin]))
    assert found[0] == pytest.approx(reach)


@any_boundary
@given(x=st.floats(-SAFE, SAFE), y=st.floats(-SAFE, SAFE), angle=st.floats(-pi, pi))
def test_a_ray_ends_on_the_boundary_wherever_it_starts(
    boundary: Boundary, x: float, y: float, angle: float
) -> None:
    reach = float(boundary.reach(np.array([angle]), np.array([[x, y]]))[0])
    end_x, end_y = x + reach * cos(angle), y + reach * sin(angle)
    if isinstance(boundary, CircularBoundary):
        assert np.hypot(end_x, end_y) == pytest.approx(0.5)
    else:
        assert max(abs(end_x) / 0.44, abs(end_y) / 0.31) == pytest.approx(1.0)


@any_boundary
@pytest.mark.parametrize("origin", [(0.5, 0.0), (0.44, 0.31), (-0.6, 0.0), (0.0, 0.7), (nan, 0.0)])
@pytest.mark.parametrize("angle", [0.0, pi / 2, 2.0, pi, -pi / 2])
def test_a_ray_that_starts_outside_counts_nothing(
    boundary: Boundary, origin: tuple[float, float], angle: float
) -> None:
    scan = Scan(np.array([angle]), np.array([0.05]), 0.6, np.array([origin]))
    assert boundary.penetrations(scan) is None


@any_boundary
def test_rays_that_start_at_the_centre_are_the_same_told_or_not(boundary: Boundary) -> None:
    ranges = np.linspace(0.05, 0.6, 128)
    plain = boundary.penetrations(Scan(np.array(RAYS), ranges, 0.6))
    told = boundary.penetrations(Scan(np.array(RAYS), ranges, 0.6, np.zeros((128, 2))))
    assert plain is not None
    assert told is not None
    assert plain.depth.tobytes() == told.depth.tobytes()
    assert plain.origins is None
    assert told.origins is not None
    assert told.origins.shape == (plain.rays.size, 2)


def test_the_rectangle_is_the_published_minimum_to_the_last_bit() -> None:
    rays = np.array(RAYS)
    with np.errstate(divide="ignore"):
        aside = (0.19 + 0.12) / np.abs(np.sin(rays))
    minimum = np.minimum((0.29 + 0.15) / np.abs(np.cos(rays)), aside)
    assert REACH.tobytes() == minimum.tobytes()


def test_a_law_turns_about_where_the_thing_is_not_where_the_ray_starts() -> None:
    # From (0.20, 0.10) looking left: met at (0.20, 0.25), 6 cm inside the boundary at 0.31.
    scan = Scan(np.array([pi / 2]), np.array([0.15]), 0.6, np.array([[0.20, 0.10]]))
    wrench = ComponentLaw().wrench(scan, PlanarTwist(0.0, 0.0, 0.0))
    assert wrench.fy == pytest.approx(-24 * 6 * 13.5 / 255)
    assert wrench.tau == pytest.approx(-315 * 6 * 0.20 * 4.4 / 255)


def test_a_page_without_a_kind_is_a_rectangle() -> None:
    assert _boundary({"layer_x": 0.3}) == RectangularBoundary(layer_x=0.3)
    assert _boundary({"kind": "circular", "radius": 0.4}) == CircularBoundary(radius=0.4)


@pytest.mark.parametrize(
    ("page", "said"),
    [
        ({"kind": "circle"}, "'rectangular', 'circular'"),
        ({"kind": "circular", "layer_x": 0.1}, "layer_x"),
        ({"kind": "circular", "radius": 0.0}, "greater than 0"),
        ("circular", "valid dictionary"),
    ],
)
def test_a_page_of_no_boundary_is_refused(page: object, said: str) -> None:
    with pytest.raises(ValidationError, match=said):
        _boundary(page)


def _boundary(page: object) -> Boundary:
    return ComponentLaw.model_validate({"boundary": page}).boundary
