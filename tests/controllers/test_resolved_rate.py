"""The four published laws, one step at a time."""

from __future__ import annotations

from math import pi, radians

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from omnistudy.arm import ArmBody, ArmState, Configuration, load_arm
from omnistudy.arm.guidance import Guidance
from omnistudy.arm.limits import limit_gradient
from omnistudy.controllers import Control, Controller
from omnistudy.controllers.resolved_rate import RateMemory
from omnistudy.devices import DeviceState
from omnistudy.errors.arm import BadGuidance
from omnistudy.geometry import ZERO_MATRIX, PlanarPose
from omnistudy.registry import load_kind

KINDS = ("sri_wln", "pi_wln", "sri_ene", "pi_ene")
BODY = ArmBody(load_arm("wmra1"))
READY = np.array(BODY.profile.ready)
DT = 0.05
UNLIMITED = {
    "avoid_limits": False,
    "limit_stop": "none",
    "speed_limits": "none",
    "zones": "none",
}
AHEAD = np.array((0.02, 0.0, 0.0, 0.0, 0.0, 0.0))

twists = st.tuples(*[st.floats(-0.05, 0.05)] * 6).map(np.array)
postures = st.lists(st.floats(-1.5, 1.5), min_size=7, max_size=7).map(lambda q: READY + np.array(q))
chairs = st.builds(PlanarPose, st.floats(-3, 3), st.floats(-3, 3), st.floats(-pi, pi))


def law(kind: str, **given_parameters: object) -> Controller:
    made: Controller = load_kind("controllers", kind)(**given_parameters)
    return made


def step(
    controller: Controller,
    at: Configuration,
    twist: np.ndarray,
    state: RateMemory | None = None,
) -> Control:
    numbers = Guidance(twist).numbers
    device = DeviceState(numbers, (0.0,) * len(numbers))
    memory = state or controller.initial_state()
    return controller.control(device, ArmState(at), None, memory, DT)


def configuration(joints: np.ndarray = READY, chair: PlanarPose | None = None) -> Configuration:
    return Configuration(BODY, joints, chair or PlanarPose(0.0, 0.0, 0.0))


@given(st.sampled_from(KINDS), postures, chairs, twists)
def test_away_from_singularities_the_hand_does_what_is_asked(
    kind: str, joints: np.ndarray, chair: PlanarPose, twist: np.ndarray
) -> None:
    at = configuration(joints, chair)
    control = step(law(kind, **UNLIMITED), at, twist)
    assume(control.state.report.damping == 0.0)
    assume(control.state.report.manipulability > 1e-4)
    assert at.jacobian @ control.command == pytest.approx(twist, abs=1e-7)


@given(postures, twists)
def test_pseudo_inverse_is_the_least_of_all_that_do_it(
    joints: np.ndarray, twist: np.ndarray
) -> None:
    at = configuration(joints)
    control = step(law("pi_ene", **UNLIMITED), at, twist)
    assume(control.state.report.manipulability > 1e-3)
    rows = at.jacobian.copy()
    rows[:, 7] *= 0.168
    least = np.linalg.pinv(rows) @ twist
    least[7] *= 0.168
    assert control.command == pytest.approx(least, abs=1e-8)


@pytest.mark.parametrize("kind", KINDS)
@given(chairs, twists)
def test_where_the_chair_stands_changes_nothing(
    kind: str, chair: PlanarPose, twist: np.ndarray
) -> None:
    turned = configuration(READY + 0.1, chair)
    straight = configuration(READY + 0.1)
    frame = {**UNLIMITED, "frame": "wheelchair"}
    assert step(law(kind, **frame), turned, twist).command == pytest.approx(
        step(law(kind, **frame), straight, twist).command, abs=1e-9
    )


@pytest.mark.parametrize("kind", KINDS)
@given(chairs, twists)
def test_the_grippers_axes(kind: str, chair: PlanarPose, twist: np.ndarray) -> None:
    at = configuration(READY + 0.1, chair)
    asked = step(law(kind, **UNLIMITED, frame="gripper"), at, twist)
    turned = at.hand[:3, :3]
    in_ground = np.concatenate((turned @ twist[:3], turned @ twist[3:]))
    assert asked.command == pytest.approx(
        step(law(kind, **UNLIMITED), at, in_ground).command, abs=1e-9
    )


@pytest.mark.parametrize("kind", KINDS)
def test_position_alone_leaves_the_turn_free(kind: str) -> None:
    at = configuration()
    full = step(law(kind, **UNLIMITED), at, AHEAD).command
    place = step(law(kind, **UNLIMITED, follows="position"), at, AHEAD).command
    assert (at.jacobian @ place)[:3] == pytest.approx(AHEAD[:3], abs=1e-9)
    assert np.abs((at.jacobian @ place)[3:]).max() > 1e-3
    # with less to do it moves less
    assert np.linalg.norm(place[:7]) < np.linalg.norm(full[:7])


@pytest.mark.parametrize("kind", KINDS)
def test_the_arm_alone_and_the_chair_alone(kind: str) -> None:
    at = configuration(READY + 0.2)
    arm = step(law(kind, **UNLIMITED, moves="arm"), at, AHEAD).command
    assert (arm[7:] == 0.0).all()
    assert at.jacobian @ arm == pytest.approx(AHEAD, abs=1e-9)
    chair = step(law(kind, **UNLIMITED, moves="chair"), at, AHEAD).command
    assert (chair[:7] == 0.0).all()
    assert (at.jacobian @ chair)[:2] == pytest.approx(AHEAD[:2], abs=1e-9)


def test_a_heavy_drive_drives_little() -> None:
    at = configuration()
    light, heavy = (
        step(
            law("sri_wln", **UNLIMITED, chair_weights={"kind": "fixed", "drive": drive}), at, AHEAD
        ).command[7]
        for drive in (0.1, 1000.0)
    )
    assert abs(heavy) < 0.01 * abs(light)


@pytest.mark.parametrize(("kind", "answers"), [("sri_wln", True), ("pi_wln", False)])
def test_a_singular_posture_is_damped_or_stands_still(kind: str, answers: bool) -> None:
    # all joints at zero: the arm is stretched, and its wrist has lost an axis
    at = configuration(np.zeros(7))
    control = step(law(kind, **UNLIMITED), at, np.array((0.01, 0.0, 0.01, 0.0, 0.0, 0.1)))
    assert np.isfinite(control.command).all()
    assert (control.command != 0.0).any() == answers
    assert ("singular" in control.state.report.hits) != answers


def near_limit(offset: float) -> np.ndarray:
    joints = READY + 0.1
    joints[6] = radians(200) + offset
    return joints


TURN_ON = np.array((0.0, 0.0, 0.0, 1.0, 0.0, 0.0))
"""Turns the hand about its own axis: joint 7 would turn on."""


@pytest.mark.parametrize("kind", KINDS)
def test_a_joint_stops_at_its_limit_and_the_others_do_its_work(kind: str) -> None:
    at = configuration(near_limit(-1e-4))
    wanted = 0.1 * at.jacobian[:, 6]  # as if joint 7 alone were to turn by 0.1 rad/s
    free = {**UNLIMITED, "avoid_limits": False}
    unstopped = step(law(kind, **free), at, wanted).command
    assert unstopped[6] * DT > 1e-4
    stopped = step(law(kind, **{**free, "limit_stop": "one_sided"}), at, wanted)
    assert stopped.command[6] == 0.0
    assert stopped.state.report.hits == ("limit 7",)
    assert at.jacobian @ stopped.command == pytest.approx(wanted, abs=1e-9)


def test_the_published_stop_holds_a_joint_even_on_its_way_back() -> None:
    at = configuration(near_limit(1e-4))
    back = -0.1 * at.jacobian[:, 6]
    legacy = step(law("sri_wln", **{**UNLIMITED, "limit_stop": "legacy"}), at, back)
    assert legacy.command[6] == 0.0
    assert legacy.state.report.hits == ("limit 7",)
    assert at.jacobian @ legacy.command != pytest.approx(back, abs=1e-3)
    mended = step(law("sri_wln", **{**UNLIMITED, "limit_stop": "one_sided"}), at, back)
    assert mended.command[6] < 0.0
    assert mended.state.report.hits == ()


def test_a_joint_near_its_limit_gets_dearer_only_while_it_nears_it() -> None:
    controller = law("sri_wln", **{**UNLIMITED, "avoid_limits": True})
    near, nearer = configuration(near_limit(-0.3)), configuration(near_limit(-0.2))
    wanted = 0.1 * near.jacobian[:, 6]
    first = step(controller, near, wanted)
    on = step(controller, nearer, wanted, first.state).command[6]
    back = step(controller, near, wanted, step(controller, nearer, wanted).state).command[6]
    assert abs(on) < 0.5 * abs(back)


def test_the_published_memory_chatters_when_a_joint_leaves_its_limit() -> None:
    places = [configuration(near_limit(-0.2 - 0.05 * index)) for index in range(4)]
    added: dict[str, list[bool]] = {}
    for memory in ("legacy", "kept"):
        controller = law("sri_wln", **{**UNLIMITED, "avoid_limits": True, "limit_memory": memory})
        state = step(controller, places[0], AHEAD).state
        dear = []
        for at in places[1:]:
            before = state
            state = step(controller, at, AHEAD, before).state
            dear.append(abs(state.gradient[6]) > 0.0)
        added[memory] = dear
    # remembered gradients: set to zero and forgotten in turns, or kept as they are
    assert added == {"legacy": [False, True, False], "kept": [True, True, True]}


FAST = np.array((0.3, 0.3, 0.0, 0.0, 0.0, 1.0))


@pytest.mark.parametrize("kind", KINDS)
def test_uniform_slowing_keeps_the_direction(kind: str) -> None:
    at = configuration(READY + 0.1)
    control = step(law(kind, **{**UNLIMITED, "speed_limits": "uniform"}), at, FAST)
    top = BODY.top_rates
    assert np.abs(control.command / top).max() == pytest.approx(1.0)
    done = at.jacobian @ control.command
    assert done / np.linalg.norm(done) == pytest.approx(FAST / np.linalg.norm(FAST), abs=1e-9)
    assert control.state.report.hits[0].startswith("speed ")


def test_published_clipping_bends_the_path() -> None:
    at = configuration(READY + 0.1)
    control = step(law("sri_wln", **{**UNLIMITED, "speed_limits": "legacy"}), at, FAST)
    assert (np.abs(control.command) <= BODY.top_rates).all()
    done = at.jacobian @ control.command
    assert abs(done[0] / done[1] - 1.0) > 0.01


def to_lap() -> Configuration:
    """The hand one centimetre above the zone over the user's lap."""
    joints = np.radians([70.0, 120.0, -60.0, 120.0, 60.0, 60.0, 0.0])
    at = configuration(joints)
    for _ in range(400):
        goal = np.array((0.1, -0.2, 0.53 + 0.350, 0.0, 0.0, 0.0))
        goal[:3] -= at.hand[:3, 3]
        if np.abs(goal[:3]).max() < 1e-4:
            return at
        command = step(law("sri_wln", **UNLIMITED, follows="position", moves="arm"), at, goal)
        at = at.moved(command.command, 0.2)
    raise AssertionError(at.hand[:3, 3])


def test_zones_stop_all_or_send_the_arm_back_while_the_chair_drives_on() -> None:
    at = to_lap()
    assert "lap" not in at.intrusions.names
    down = np.array((0.05, 0.0, -0.5, 0.0, 0.0, 0.0))
    free = step(law("sri_wln", **UNLIMITED), at, down)
    assert "lap" in at.moved(free.command, DT).intrusions.names
    stopped = step(law("sri_wln", **{**UNLIMITED, "zones": "stop"}), at, down)
    assert (stopped.command == 0.0).all()
    assert "zone lap" in stopped.state.report.hits
    legacy = step(law("sri_wln", **{**UNLIMITED, "zones": "legacy"}), at, down)
    assert legacy.command[:7] == pytest.approx(-0.01 * free.command[:7])
    assert legacy.command[7:] == pytest.approx(free.command[7:])


def test_from_inside_a_zone_there_is_a_way_out() -> None:
    at = to_lap()
    down = np.array((0.0, 0.0, -0.5, 0.0, 0.0, 0.0))
    inside = at.moved(step(law("sri_wln", **UNLIMITED), at, down).command, 0.1)
    assert "lap" in inside.intrusions.names
    stops = law("sri_wln", **{**UNLIMITED, "zones": "stop"})
    assert (step(stops, inside, 0.1 * down).command == 0.0).all()
    assert (step(stops, inside, -0.1 * down).command != 0.0).any()


@pytest.mark.parametrize(("slide", "nearer"), [("legacy", True), ("away", False)])
def test_the_published_slide_goes_towards_the_limit(slide: str, nearer: bool) -> None:
    joints = READY + 0.1
    joints[1] = radians(165)
    at = configuration(joints)
    parameters = {**UNLIMITED, "avoid_limits": True, "gain": 0.02}
    control = step(law("pi_ene", **parameters, slide=slide), at, np.zeros(6))
    assert at.jacobian @ control.command == pytest.approx(np.zeros(6), abs=1e-9)
    climb = limit_gradient(joints, BODY.lower, BODY.upper) @ control.command[:7]
    assert (climb > 0.0) == nearer


def test_a_slide_is_never_faster_than_the_joints() -> None:
    joints = READY + 0.1
    joints[1] = BODY.upper[1]
    at = configuration(joints)
    control = step(law("pi_ene", **{**UNLIMITED, "avoid_limits": True}), at, np.zeros(6))
    assert np.isfinite(control.command).all()
    assert (np.abs(control.command) <= BODY.top_rates * (1 + 1e-9)).all()


def test_the_intent_is_what_the_device_says_and_no_law_damps_it() -> None:
    control = step(law("sri_wln"), configuration(), AHEAD)
    assert control.intent == tuple(AHEAD)
    # where the chair should end is no command: a hand that asks for nothing is at rest
    resting = Guidance(np.zeros(6), 0.5, PlanarPose(1.0, 2.0, 3.0)).numbers
    device = DeviceState(resting, (0.0,) * 10)
    at_rest = law("sri_wln").control(device, ArmState(configuration()), None, RateMemory(), DT)
    assert not any(at_rest.intent)
    assert law("sri_wln").twist_per_stick == ZERO_MATRIX


@pytest.mark.parametrize("numbers", [(0.0,) * 3, (0.0,) * 8])
def test_a_stick_leads_no_arm(numbers: tuple[float, ...]) -> None:
    with pytest.raises(BadGuidance, match=f"led by {len(numbers)} numbers: give 6"):
        law("sri_wln").control(
            DeviceState(numbers, numbers), ArmState(configuration()), None, RateMemory(), DT
        )


def test_guidance_is_read_back() -> None:
    for guidance in (
        Guidance(AHEAD),
        Guidance(AHEAD, 0.5),
        Guidance(AHEAD, 0.5, PlanarPose(1.0, 2.0, 3.0)),
    ):
        again = Guidance.read(guidance.numbers)
        assert again.numbers == guidance.numbers
        assert again.chair_goal == guidance.chair_goal
