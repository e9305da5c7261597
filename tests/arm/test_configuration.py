"""Where joints and chair put the hand, and how it moves when they do."""

from __future__ import annotations

from math import degrees, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omnistudy.arm import ArmBody, Configuration, load_arm
from omnistudy.geometry import PlanarPose
from omnistudy.geometry.rigid_motion import pose_error

MM = 1000.0

BODIES = {name: ArmBody(load_arm(name)) for name in ("wmra1", "wmra1_vr", "wmra2")}
ORIGIN = PlanarPose(0.0, 0.0, 0.0)

joints = st.lists(st.floats(-pi, pi), min_size=7, max_size=7).map(np.array)
chairs = st.builds(PlanarPose, st.floats(-5, 5), st.floats(-5, 5), st.floats(-pi, pi))


def ready(name: str) -> Configuration:
    body = BODIES[name]
    return Configuration(body, np.array(body.profile.ready), ORIGIN)


@pytest.mark.parametrize(
    ("name", "place"),
    [
        # recorded with the lab's program for the first arm; the two others from their lengths
        ("wmra1", (586.0, -131.0, 899.0)),
        ("wmra1_vr", (517.12, -125.95, 849.67)),
        ("wmra2", (527.0, -273.0, 872.0)),
    ],
)
def test_ready_postures(name: str, place: tuple[float, float, float]) -> None:
    assert MM * ready(name).hand[:3, 3] == pytest.approx(place, abs=1e-9)


def test_the_ready_hand_points_forward_with_its_x_to_the_right() -> None:
    forward, right, down = (1, 0, 0), (0, -1, 0), (0, 0, -1)
    turned = ready("wmra1").hand[:3, :3]
    assert turned == pytest.approx(np.column_stack((right, down, forward)), abs=1e-12)


def test_the_stretched_arm_reaches_as_far_as_its_lengths() -> None:
    # all joints at zero: d1 sideways, then up and down in turns by d2 to d7
    at = Configuration(BODIES["wmra1"], np.zeros(7), ORIGIN)
    aside, up = 0.110 + 0.549 * 0.0, 0.350
    assert at.hand[:3, 3] == pytest.approx(
        (0.0, aside + 0.549 + 0.241 + 0.310, up + 0.146 + 0.130), abs=1e-12
    )


def test_recorded_manipulability_of_the_ready_posture() -> None:
    at = ready("wmra1")
    assert MM**3 * at.arm_manipulability == pytest.approx(1.2078268e8, rel=1e-7)
    rows = at.jacobian.copy()
    rows[:3] *= MM
    rows[:, 7] *= 0.168  # the lab counts the drive in radians of the wheels
    assert sqrt(np.linalg.det(rows @ rows.T)) == pytest.approx(3.2383381e8, rel=1e-7)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(sorted(BODIES)), joints, chairs)
def test_both_jacobians_match_finite_differences(
    name: str, angles: np.ndarray, chair: PlanarPose
) -> None:
    body = BODIES[name]
    at = Configuration(body, angles, chair)
    h = 1e-6
    for index in range(9):
        rates = np.zeros(9)
        rates[index] = 1.0
        ahead, behind = at.moved(rates, h), at.moved(rates, -h)
        difference = pose_error(behind.hand, ahead.hand) / (2.0 * h)
        assert at.jacobian[:, index] == pytest.approx(difference, abs=1e-7)
        if index < 7:
            turned = at.base[:3, :3].T
            local = np.concatenate((turned @ difference[:3], turned @ difference[3:]))
            assert at.arm_jacobian[:, index] == pytest.approx(local, abs=1e-7)


def test_moving_leaves_the_configuration_before_as_it_was() -> None:
    at = ready("wmra1")
    before = at.joints.copy()
    after = at.moved(np.ones(9), 0.1)
    assert (at.joints == before).all()
    assert after.joints == pytest.approx(before + 0.1)
    assert degrees(after.chair.theta) == pytest.approx(degrees(0.1))


def test_each_joints_frame_turns_about_its_own_axis() -> None:
    # the first joint's axis is the chair's sideways one
    frames = BODIES["wmra1"].frames(np.zeros(7))
    assert frames[0, :3, 2] == pytest.approx((0.0, 1.0, 0.0))
    assert frames[0, :3, 3] == pytest.approx((0.0, 0.110, 0.0))
