"""How the wheelchair carries the arm's base over the floor."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.arm import load_arm
from omnistudy.arm.chair import (
    axle,
    driven,
    hand_per_rates,
    hand_per_wheels,
    pose_of_axle,
    rates_per_wheels,
)
from omnistudy.geometry import PlanarPose

CHAIR = load_arm("wmra1").chair
poses = st.builds(PlanarPose, st.floats(-5, 5), st.floats(-5, 5), st.floats(-pi, pi))


def test_at_the_origin_the_axle_is_behind_and_to_the_right_of_the_arms_base() -> None:
    assert axle(CHAIR, PlanarPose(0.0, 0.0, 0.0)) == (-0.440, -0.230, 0.0)


@given(poses)
def test_axle_and_base_tell_the_same(pose: PlanarPose) -> None:
    assert pose_of_axle(CHAIR, axle(CHAIR, pose)) == pytest.approx(pose)


def test_straight_ahead() -> None:
    assert driven(CHAIR, PlanarPose(1.0, 2.0, pi / 2), 0.5, 0.0) == pytest.approx(
        (1.0, 2.5, pi / 2)
    )


def test_a_turn_on_the_spot_leaves_the_axle() -> None:
    start = PlanarPose(0.3, -0.2, 0.4)
    end = driven(CHAIR, start, 0.0, 1.2)
    assert axle(CHAIR, end) == pytest.approx((*axle(CHAIR, start)[:2], 1.6))


def test_a_quarter_circle_of_one_metre() -> None:
    # the axle goes from (-0.44, -0.23) round a point one metre to its left
    end = axle(CHAIR, driven(CHAIR, PlanarPose(0.0, 0.0, 0.0), pi / 2, pi / 2))
    assert end == pytest.approx((-0.44 + 1.0, -0.23 + 1.0, pi / 2))


@given(poses, st.floats(-0.5, 0.5), st.floats(-1.0, 1.0))
def test_one_long_arc_is_many_short_ones(pose: PlanarPose, way: float, turn: float) -> None:
    at = pose
    for _ in range(50):
        at = driven(CHAIR, at, way / 50, turn / 50)
    assert at == pytest.approx(driven(CHAIR, pose, way, turn), abs=1e-9)


@given(st.floats(-pi, pi), st.tuples(st.floats(-1, 1), st.floats(-1, 1)))
def test_equation_5_as_it_is_printed(heading: float, hand: tuple[float, float]) -> None:
    # J_c and J_W of eq. (5), P_xg and P_yg being the hand's place from the arm's base
    c, s = cos(heading), sin(heading)
    l1, l2, l3, l5 = CHAIR.track, CHAIR.arm_x, CHAIR.arm_y, CHAIR.wheel_radius
    px, py = hand
    j_c = np.zeros((6, 3))
    j_c[0], j_c[1], j_c[5] = (1, 0, -(px * s + py * c)), (0, 1, px * c - py * s), (0, 0, 1)
    forward, aside = l2 * s + l3 * c, l2 * c - l3 * s
    j_w = (
        0.5
        * l5
        * np.array(
            [
                [c + 2 / l1 * forward, c - 2 / l1 * forward],
                [s - 2 / l1 * aside, s + 2 / l1 * aside],
                [-2 / l1, 2 / l1],
            ]
        )
    )
    assert hand_per_wheels(CHAIR, heading, hand) == pytest.approx(j_c @ j_w, abs=1e-12)


def test_the_map_that_equation_6_leaves_out() -> None:
    # drive in wheel radians and turn -> left and right wheel: [1, -l1/2l5; 1, l1/2l5]
    half = CHAIR.track / (2 * CHAIR.wheel_radius)
    wheels = np.array([[1.0, -half], [1.0, half]])
    back = rates_per_wheels(CHAIR) @ wheels
    assert back == pytest.approx(np.diag((CHAIR.wheel_radius, 1.0)))


def test_only_a_turn_moves_the_hand_sideways() -> None:
    rates = hand_per_rates(CHAIR, 0.0, (0.586, -0.131))
    assert rates[:, 0] == pytest.approx((1, 0, 0, 0, 0, 0))
    # lever from the axle: 0.440 + 0.586 ahead, 0.230 - 0.131 to the left
    assert rates[:, 1] == pytest.approx((-0.099, 1.026, 0, 0, 0, 1))
