"""The rectangle around the robot: 0.44 m ahead and behind, 0.31 m aside."""

from __future__ import annotations

from math import inf, nan, pi

import numpy as np
import pytest
from laws.straight_walls import RAYS

from omnistudy.geometry import Scan
from omnistudy.laws.boundary import RectangularBoundary

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
