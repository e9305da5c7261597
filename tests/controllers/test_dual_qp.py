"""One step of the quadratic programme that leads hand and chair together."""

from __future__ import annotations

from math import nan, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.arm import ArmBody, ArmState, Configuration, load_arm
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.profile import ArmProfile
from omnistudy.controllers import Control
from omnistudy.controllers.dual_qp import DualQp
from omnistudy.devices import DeviceState
from omnistudy.geometry import ZERO_MATRIX, PlanarPose
from omnistudy.registry import load_kind

BODY = ArmBody(load_arm("wmra1"))
READY = np.array(BODY.profile.ready)
HERE = PlanarPose(0.0, 0.0, 0.0)
DT = 0.05
AHEAD = np.array((0.02, 0.0, 0.0, 0.0, 0.0, 0.0))
NOTHING = np.zeros(6)
TOLERANCE = 1e-5

postures = st.lists(st.floats(-1.5, 1.5), min_size=7, max_size=7).map(
    lambda q: np.clip(READY + np.array(q), BODY.lower, BODY.upper)
)
twists = st.tuples(*[st.floats(-0.3, 0.3)] * 6).map(np.array)
chairs = st.builds(PlanarPose, st.floats(-3, 3), st.floats(-3, 3), st.floats(-pi, pi))
chair_rates = st.none() | st.tuples(st.floats(-0.3, 0.3), st.floats(-0.5, 0.5))


def step(at: Configuration, guidance: Guidance, law: DualQp | None = None) -> Control:
    device = DeviceState(guidance.numbers, (0.0,) * len(guidance.numbers))
    controller = law or DualQp()
    return controller.control(device, ArmState(at), None, controller.initial_state(), DT)


def led(
    twist: np.ndarray,
    rates: tuple[float, float] | None = None,
    correction: np.ndarray = NOTHING,
    posture: np.ndarray | None = None,
) -> Guidance:
    return Guidance(twist, nan, None, rates, correction, posture)


def at_ready(chair: PlanarPose = HERE) -> Configuration:
    return Configuration(BODY, READY, chair)


def test_it_is_a_kind_that_no_law_damps() -> None:
    assert load_kind("controllers", "dual_qp") is DualQp
    assert DualQp().twist_per_stick == ZERO_MATRIX


@pytest.mark.parametrize("chair", [HERE, PlanarPose(1.0, -2.0, 2.0)])
def test_a_persons_twist_is_done_by_arm_and_chair(chair: PlanarPose) -> None:
    at = at_ready(chair)
    control = step(at, Guidance(AHEAD))
    assert at.jacobian @ control.command == pytest.approx(AHEAD, abs=TOLERANCE)
    assert control.state.report.progress == pytest.approx(1.0, abs=1e-3)
    assert control.state.report.hits == ()


def test_a_led_chair_does_its_rates_and_the_arm_makes_up_for_them() -> None:
    at = at_ready(PlanarPose(0.5, 0.5, 1.0))
    control = step(at, led(AHEAD, (0.05, -0.03)))
    assert control.command[7:] == pytest.approx((0.05, -0.03), rel=1e-3)
    assert at.jacobian @ control.command == pytest.approx(AHEAD, abs=TOLERANCE)


def test_hand_and_chair_slow_down_together() -> None:
    # ten times what the chair can drive
    at = at_ready()
    control = step(at, led(10 * AHEAD, (1.0, 0.0)))
    share = control.state.report.progress
    assert share == pytest.approx(0.1, rel=1e-2)
    assert control.command[7] == pytest.approx(share, rel=1e-6)
    assert at.jacobian @ control.command == pytest.approx(share * 10 * AHEAD, abs=1e-4)
    assert control.state.report.hits == ("speed 8",)


def test_what_brings_the_hand_back_is_not_slowed() -> None:
    back = np.array((0.0, 0.0, 0.01, 0.0, 0.0, 0.0))
    at = at_ready()
    control = step(at, led(10 * AHEAD + back, (1.0, 0.0), back))
    assert (at.jacobian @ control.command)[2] == pytest.approx(0.01, rel=1e-2)


@given(postures, chairs, twists, chair_rates)
def test_no_limit_of_speeds_and_joints_is_passed(
    joints: np.ndarray, chair: PlanarPose, twist: np.ndarray, rates: tuple[float, float] | None
) -> None:
    at = Configuration(BODY, joints, chair)
    control = step(at, led(twist, rates))
    assert (np.abs(control.command) <= BODY.top_rates + TOLERANCE).all()
    after = joints + DT * control.command[:7]
    assert ((after >= BODY.lower - DT * TOLERANCE) & (after <= BODY.upper + DT * TOLERANCE)).all()
    assert -TOLERANCE <= control.state.report.progress <= 1.0 + TOLERANCE
    assert "unsolved" not in control.state.report.hits


@given(postures, twists, chair_rates)
def test_no_zone_is_entered_and_none_is_entered_deeper(
    joints: np.ndarray, twist: np.ndarray, rates: tuple[float, float] | None
) -> None:
    at = Configuration(BODY, joints, HERE)
    before = BODY.clearances.near(at.frames, 99.0)
    after = BODY.clearances.near(at.moved(step(at, led(twist, rates)).command, DT).frames, 99.0)
    # a step is straight for the joints, not for the arm: half of (0.5 rad/s 0.05 s)^2 times 1.4 m,
    # some joints together
    bent = 0.003
    assert (after.rooms >= np.minimum(before.rooms, 0.0) - bent).all()


def test_a_joint_at_its_limit_stays_and_is_named() -> None:
    joints = READY.copy()
    joints[5] = BODY.upper[5]
    at = Configuration(BODY, joints, HERE)
    # what joint 6 alone would do at 0.1 rad/s, beyond its limit
    beyond = at.jacobian[:, 5] * 0.1
    control = step(at, led(beyond, (0.0, 0.0)))
    assert control.command[5] <= TOLERANCE
    back = step(at, led(-beyond, (0.0, 0.0)))
    assert back.state.report.progress == pytest.approx(1.0, abs=1e-2)


def test_an_elbow_beside_its_zone_stops_there_and_says_so() -> None:
    # only joint 1 moves joint 3 sideways while the arm is bent so; 1 cm is left
    law = DualQp(posture=0.0)
    at = at_ready()
    hits: set[str] = set()
    for _ in range(100):
        control = step(at, led(np.array((0.0, -0.05, 0.0, 0.0, 0.0, 0.0)), (0.0, 0.0)), law)
        hits.update(control.state.report.hits)
        at = at.moved(control.command, DT)
        assert at.intrusions.names == ()
    assert any(hit.startswith("zone") for hit in hits)


def test_without_zones_it_goes_through_them() -> None:
    at, through = at_ready(), DualQp(zones="none", posture=0.0)
    entered = False
    for _ in range(100):
        control = step(at, led(np.array((0.0, -0.05, 0.0, 0.0, 0.0, 0.0)), (0.0, 0.0)), through)
        at = at.moved(control.command, DT)
        entered |= bool(at.intrusions.names)
    assert entered


def test_a_posture_is_taken_without_moving_the_hand() -> None:
    at = at_ready()
    wanted = np.array((0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    control = step(at, led(NOTHING, (0.0, 0.0), posture=wanted))
    assert np.abs(control.command[:7]).max() > 0.005
    assert float(control.command[:7] @ wanted) > 0.0
    assert at.jacobian @ control.command == pytest.approx(np.zeros(6), abs=TOLERANCE)


def test_position_alone_leaves_the_hands_rotation_free() -> None:
    at = at_ready()
    law = DualQp(follows="position")
    control = step(at, led(np.array((0.02, 0, 0, 1.0, 1.0, 1.0)), (0.0, 0.0)), law)
    moved = at.jacobian @ control.command
    assert moved[:3] == pytest.approx((0.02, 0.0, 0.0), abs=TOLERANCE)
    assert control.state.report.progress == pytest.approx(1.0, abs=1e-3)


def test_the_grippers_ahead_is_the_grounds_x_in_the_ready_posture() -> None:
    ahead = Guidance(np.array((0.0, 0.0, 0.02, 0.0, 0.0, 0.0)))
    of_hand = step(at_ready(), ahead, DualQp(frame="gripper")).command
    assert of_hand == pytest.approx(step(at_ready(), Guidance(AHEAD)).command, abs=1e-9)


def test_the_wheelchairs_axes_turn_with_it() -> None:
    turned = at_ready(PlanarPose(0.0, 0.0, pi / 2))
    of_chair = step(turned, Guidance(AHEAD), DualQp(frame="wheelchair")).command
    left = Guidance(np.array((0.0, 0.02, 0.0, 0.0, 0.0, 0.0)))
    assert of_chair == pytest.approx(step(turned, left).command, abs=1e-9)


def test_a_stretched_arm_is_not_flung() -> None:
    # elbow and wrist straight: no rate of the joints moves the hand along the arm
    joints = np.array((pi / 2, pi / 2, 0.0, 0.0, 0.0, 0.0, 0.0))
    at = Configuration(BODY, joints, HERE)
    assert at.arm_manipulability < 1e-9
    for twist in np.vstack((0.05 * np.eye(6), -0.05 * np.eye(6))):
        control = step(at, led(twist, (0.0, 0.0)))
        share = control.state.report.progress
        off = at.jacobian @ control.command - share * twist
        assert np.linalg.norm(off) < 2e-3
        assert (np.abs(control.command) <= BODY.top_rates + TOLERANCE).all()


@pytest.mark.parametrize("name", ["wmra1", "wmra1_vr", "wmra2"])
def test_every_profile_is_led(name: str) -> None:
    profile: ArmProfile = load_arm(name)
    at = Configuration(ArmBody(profile), np.array(profile.ready), HERE)
    assert at.jacobian @ step(at, Guidance(AHEAD)).command == pytest.approx(AHEAD, abs=TOLERANCE)
