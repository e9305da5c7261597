"""Lines and arcs that a hand is led along."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.arm.paths import ArcPath, LinePath, Path
from omnistudy.geometry.rigid_motion import Floats, pose_error, rotation, transform

X, Y, Z = np.eye(3)
axes = st.tuples(*[st.floats(-1, 1)] * 3).map(np.array).filter(lambda v: np.linalg.norm(v) > 0.1)
places = st.tuples(*[st.floats(-2, 2)] * 3).map(np.array)


@st.composite
def poses(draw: st.DrawFn) -> Floats:
    axis = draw(axes)
    return transform(rotation(axis / np.linalg.norm(axis), draw(st.floats(0, pi))), draw(places))


@st.composite
def arcs(draw: st.DrawFn) -> ArcPath:
    axis = draw(axes)
    return ArcPath(
        start=draw(poses()),
        hinge=draw(places),
        axis=axis / np.linalg.norm(axis),
        turn=draw(st.floats(-pi, pi)),
        following=draw(st.booleans()),
    )


paths = st.one_of(st.builds(LinePath, poses(), poses()), arcs())


@given(poses(), poses())
def test_a_line_begins_and_ends_where_it_should(start: Floats, goal: Floats) -> None:
    path = LinePath(start, goal)
    assert path.pose(0.0) == pytest.approx(start, abs=1e-9)
    assert path.pose(1.0) == pytest.approx(goal, abs=1e-7)


@given(paths, st.floats(0.01, 0.99))
def test_a_tangent_is_the_change_of_the_pose(path: Path, share: float) -> None:
    h = 1e-6
    change = pose_error(path.pose(share - h), path.pose(share + h)) / (2 * h)
    assert path.tangent(share) == pytest.approx(change, abs=1e-6)


@given(paths)
def test_length_and_angle_are_those_of_the_tangent(path: Path) -> None:
    tangent = path.tangent(0.5)
    assert path.length == pytest.approx(float(np.linalg.norm(tangent[:3])), abs=1e-9)
    assert path.angle == pytest.approx(float(np.linalg.norm(tangent[3:])), abs=1e-9)


def test_half_a_turn_has_an_axis_and_an_end() -> None:
    goal = transform(rotation(Z, pi), np.zeros(3))
    path = LinePath(np.eye(4), goal)
    assert path.angle == pytest.approx(pi)
    assert abs(path.pose(0.5)[:3, :3] @ X) == pytest.approx(Y)
    assert path.pose(1.0) == pytest.approx(goal)


def test_a_path_that_leads_nowhere_stays() -> None:
    path = LinePath(np.eye(4), np.eye(4))
    assert (path.length, path.angle) == (0.0, 0.0)
    assert path.pose(0.7) == pytest.approx(np.eye(4))
    assert (path.tangent(0.7) == 0.0).all()


@pytest.mark.parametrize(
    ("following", "points_to"), [(True, (0.0, 1.0, 0.0)), (False, (1.0, 0.0, 0.0))]
)
def test_a_door_with_its_hinge_to_the_right(
    following: bool, points_to: tuple[float, float, float]
) -> None:
    # hinge one metre to the right of the hand, opened by a quarter towards the hand's back
    start = transform(np.eye(3), np.array((2.0, 1.0, 1.0)))
    path = ArcPath(start, np.array((2.0, 0.0, 1.0)), Z, pi / 2, following)
    assert path.length == pytest.approx(1.5708, abs=1e-4)
    assert path.pose(1.0)[:3, 3] == pytest.approx((1.0, 0.0, 1.0))
    assert path.pose(1.0)[:3, 0] == pytest.approx(points_to)
    assert path.leads == pytest.approx((-1.0, -1.0))


def test_only_the_distance_from_the_axis_counts() -> None:
    path = ArcPath(np.eye(4), np.array((0.3, 0.4, 7.0)), Z, 1.0, True)
    assert path.length == pytest.approx(0.5)
