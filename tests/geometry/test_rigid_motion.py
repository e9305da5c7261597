"""Rotations and poses in space."""

from __future__ import annotations

from math import pi, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.geometry.rigid_motion import (
    Floats,
    inverse,
    pose_error,
    quaternion,
    rotation,
    rotation_vector,
    sine_error,
    transform,
)

X, Y, Z = np.eye(3)

axes = st.tuples(*[st.floats(-1, 1)] * 3).map(np.array).filter(lambda v: np.linalg.norm(v) > 0.1)
angles = st.one_of(
    st.floats(1e-12, pi),
    st.floats(1e-12, 1e-6),
    st.floats(0, 1e-6).map(lambda small: pi - small),
    st.just(pi),
)


def unit(axis: Floats) -> Floats:
    return axis / np.linalg.norm(axis)


def test_a_quarter_turn_about_z_brings_x_to_y() -> None:
    assert rotation(Z, pi / 2) @ X == pytest.approx(Y)


@given(axes, angles)
def test_the_logarithm_is_axis_times_angle(axis: Floats, angle: float) -> None:
    turned = rotation(unit(axis), angle)
    found = rotation_vector(turned)
    assert np.linalg.norm(found) == pytest.approx(angle, abs=1e-7)
    again = rotation(unit(found), float(np.linalg.norm(found)))
    assert again == pytest.approx(turned, abs=1e-7)


@given(axes, st.floats(pi - 1e-3, pi - 1e-9))
def test_near_half_a_turn_the_axis_keeps_its_sign(axis: Floats, angle: float) -> None:
    found = rotation_vector(rotation(unit(axis), angle))
    assert found == pytest.approx(angle * unit(axis), abs=1e-6)


def test_at_half_a_turn_the_error_is_half_a_turn_where_the_thesis_has_none() -> None:
    start, goal = np.eye(4), transform(rotation(X, pi), np.zeros(3))
    assert np.linalg.norm(pose_error(start, goal)[3:]) == pytest.approx(pi)
    assert np.linalg.norm(sine_error(start, goal)[3:]) == pytest.approx(0.0, abs=1e-12)


def test_the_published_error_is_the_sine_of_the_angle() -> None:
    start, goal = np.eye(4), transform(rotation(Y, radians(30)), np.array((0.1, 0.0, -0.2)))
    assert sine_error(start, goal) == pytest.approx((0.1, 0.0, -0.2, 0.0, 0.5, 0.0))
    assert pose_error(start, goal) == pytest.approx((0.1, 0.0, -0.2, 0.0, radians(30), 0.0))


def test_errors_are_in_ground_axes() -> None:
    start = transform(rotation(Z, pi / 2), np.zeros(3))
    goal = transform(rotation(Z, pi / 2) @ rotation(X, 0.1), np.zeros(3))
    # the hand's own x points along the ground's y
    assert pose_error(start, goal)[3:] == pytest.approx((0.0, 0.1, 0.0))
    assert sine_error(start, goal)[3:] == pytest.approx((0.0, sin(0.1), 0.0))


def test_an_inverse_undoes() -> None:
    pose = transform(rotation(unit(np.array((1.0, 2.0, 3.0))), 1.1), np.array((1.0, -2.0, 0.5)))
    assert inverse(pose) @ pose == pytest.approx(np.eye(4))


def test_quaternions_of_known_turns() -> None:
    half = sqrt(0.5)
    assert quaternion(np.eye(3)) == (0.0, 0.0, 0.0, 1.0)
    assert quaternion(rotation(Z, pi / 2)) == pytest.approx((0.0, 0.0, half, half))
    assert quaternion(rotation(X, pi)) == pytest.approx((1.0, 0.0, 0.0, 0.0), abs=1e-12)
