"""Power assist, against eq. 1.6-1.7 worked out by hand."""

from __future__ import annotations

from math import exp, inf, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.controllers import Control
from omnistudy.controllers.power_assist import (
    AssistGain,
    AssistLag,
    Centring,
    PowerAssistController,
)
from omnistudy.devices import DeviceState, Hand
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.geometry import PlanarTwist, Scan

STILL = PlanarTwist(0.0, 0.0, 0.0)
ASSIST = PowerAssistController(
    centring=Centring(x=100.0, y=50.0, theta=2.0),
    gain=AssistGain(x=0.1, y=0.2, theta=0.5),
    lag=AssistLag(x=0.2, y=0.4, theta=0.1),
    least_gap=0.1,
    top_speed=0.4,
    alpha=0.5,
    beta=10.0,
    half_length=0.3,
    half_width=0.2,
    unseen_front=0.0,
)
"""Exponent of eq. 1.7: (0.4 - |v|/2)·10, 4 at rest and 2 at 0.4 m/s."""


def step(
    position: tuple[float, float, float],
    state: PlanarTwist = STILL,
    scan: Scan | None = None,
    dt: float = 1 / 240,
    controller: PowerAssistController = ASSIST,
) -> Control:
    return controller.control(DeviceState(position, (0.0,) * 3), None, scan, state, dt)


def posts(*places: tuple[float, float], max_range: float = 3.0) -> Scan:
    """A scan that sees thin posts at (x, y) in m from the robot's centre."""
    x, y = np.array(places, np.float64).T
    return Scan(np.arctan2(y, x), np.hypot(x, y), max_range)


def test_a_held_force_is_followed_by_a_first_order_lag() -> None:
    """1 cm, 2 cm and 0.5 rad are 1 N, 1 N and 1 N·m: 0.1 m/s, 0.2 m/s and 0.5 rad/s are asked for,
    and after 0.2 s one, half and two time constants have passed."""
    result = step((0.01, 0.02, 0.5), dt=0.2)
    assert result.intent == pytest.approx((0.1, 0.2, 0.5))
    parts = (0.1 * (1 - exp(-1)), 0.2 * (1 - exp(-0.5)), 0.5 * (1 - exp(-2)))
    assert result.command == pytest.approx(parts)
    assert result.command == pytest.approx((0.063212, 0.078694, 0.432332), abs=1e-6)
    assert result.state == result.command


@given(st.lists(st.floats(0.001, 0.1), min_size=1, max_size=8))
def test_many_short_steps_are_one_long_one(steps: list[float]) -> None:
    whole = step((0.01, -0.02, 0.5), PlanarTwist(0.1, 0.1, -0.2), dt=sum(steps)).command
    state = PlanarTwist(0.1, 0.1, -0.2)
    for dt in steps:
        state = step((0.01, -0.02, 0.5), state, dt=dt).state
    assert state == pytest.approx(whole)


def test_a_stick_let_go_slows_the_robot_down() -> None:
    result = step((0.0, 0.0, 0.0), PlanarTwist(0.3, 0.0, 0.0), dt=0.2)
    assert result.intent == STILL
    assert result.command == pytest.approx((0.3 * exp(-1), 0.0, 0.0))


@pytest.mark.parametrize(
    ("gap", "speed", "share"),
    [
        (0.1, 0.0, 0.0),
        (0.05, 0.3, 0.0),
        (0.0, 0.0, 0.0),
        # rmin/r = 1/2: 1 - 1/2^4, 1 - 1/2^3, 1 - 1/2^2; no more at a speed above vmax.
        (0.2, 0.0, 0.9375),
        (0.2, 0.2, 0.875),
        (0.2, -0.2, 0.875),
        (0.2, 0.4, 0.75),
        (0.2, 9.0, 0.75),
        (1.0, 0.0, 0.9999),
        (inf, 0.4, 1.0),
    ],
)
def test_what_is_left_of_the_gain(gap: float, speed: float, share: float) -> None:
    assert ASSIST.share_of_gain(gap, speed) == pytest.approx(share)


@given(st.floats(0.0, 5.0), st.floats(0.0, 5.0), st.floats(-1.0, 1.0))
def test_farther_never_leaves_less(one: float, other: float, speed: float) -> None:
    near, far = sorted((one, other))
    assert 0.0 <= ASSIST.share_of_gain(near, speed) <= ASSIST.share_of_gain(far, speed) <= 1.0


def test_an_obstacle_on_the_way_multiplies_the_gains_of_x_and_y_alone() -> None:
    """A post 0.5 m ahead is 0.2 m before the front edge: half of the gain's fall is 1/2^4."""
    result = step((0.01, 0.0, 0.5), scan=posts((0.5, 0.0)), dt=0.2)
    assert result.intent == pytest.approx((0.1, 0.0, 0.5))
    parts = (0.9375 * 0.1 * (1 - exp(-1)), 0.0, 0.5 * (1 - exp(-2)))
    assert result.command == pytest.approx(parts)


@pytest.mark.parametrize(
    ("towards", "post", "gap"),
    [
        ((1, 0), (0.5, 0.1), 0.2),
        ((-1, 0), (-0.5, 0.1), 0.2),
        ((0, 1), (0.2, 0.5), 0.3),
        ((0, -1), (0.2, -0.5), 0.3),
        # Behind, beside the lane, or turned away from.
        ((1, 0), (-0.5, 0.1), inf),
        ((1, 0), (0.5, 0.21), inf),
        ((0, 1), (0.5, 0.5), inf),
        # Against the edge, and a little past it: leaving it and going along it are free.
        ((0, 1), (0.1, 0.2), 0.0),
        ((0, -1), (0.1, 0.195), inf),
        ((1, 0), (0.1, 0.195), inf),
        # Along (0.6, 0.8) a post at (0.58, 0.38): the front reaches x = 0.58 after 0.28 / 0.6 m,
        # the left side y = 0.38 after 0.18 / 0.8 m; the outline less 0.02 m meets it after 0.5 m.
        ((0.6, 0.8), (0.58, 0.38), 0.48),
        # Along (0.6, 0.8) what lies straight ahead is passed on the left.
        ((0.6, 0.8), (0.9, 0.0), inf),
    ],
)
def test_the_gap_is_how_far_the_outline_can_go(
    towards: tuple[float, float], post: tuple[float, float], gap: float
) -> None:
    twist = PlanarTwist(0.3 * towards[0], 0.3 * towards[1], 0.7)
    assert ASSIST.gap(posts(post, (-2.0, -2.0), (2.0, 2.9)), twist) == pytest.approx(gap)


def test_nothing_is_in_the_way_of_a_turn_on_the_spot() -> None:
    assert ASSIST.gap(posts((0.3, 0.0)), PlanarTwist(0.0, 0.0, 1.0)) == inf


def test_what_a_sensor_does_not_see_is_not_in_the_way() -> None:
    scan = Scan(np.zeros(4), np.array([0.0, np.nan, 0.6, 0.7]), 0.6)
    assert ASSIST.gap(scan, PlanarTwist(0.3, 0.0, 0.0)) == inf
    assert step((0.01, 0.0, 0.0), scan=None) == step((0.01, 0.0, 0.0), scan=scan)


@pytest.mark.parametrize(("degrees", "seen"), [(0, False), (-44, False), (46, True), (-46, True)])
def test_the_front_is_left_to_the_operator(degrees: float, seen: bool) -> None:
    """By default lidars look back and aside: rays within 45 degrees of ahead are not used."""
    angle = degrees * pi / 180
    scan = Scan(np.array([angle]), np.array([0.4]), 3.0)
    towards = PlanarTwist(np.cos(angle), np.sin(angle), 0.0)
    assert (PowerAssistController().gap(scan, towards) < inf) == seen


positions = st.tuples(st.floats(-0.04, 0.04), st.floats(-0.04, 0.04), st.floats(-1.0, 1.0))
twists = st.builds(PlanarTwist, st.floats(-0.4, 0.4), st.floats(-0.4, 0.4), st.floats(-1, 1))
scenes = st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), min_size=1, max_size=9)


@given(positions, twists, scenes)
def test_a_mirrored_scene_is_driven_mirrored(
    position: tuple[float, float, float],
    state: PlanarTwist,
    scene: list[tuple[float, float]],
) -> None:
    x, y, theta = position
    scan = posts(*scene)
    here = step(position, state, scan).command
    flipped = PlanarTwist(state.vx, -state.vy, -state.omega)
    there = step((x, -y, -theta), flipped, scan.mirrored()).command
    assert there == pytest.approx((here.vx, -here.vy, -here.omega))


def test_twist_per_stick_is_the_slope_of_the_intent() -> None:
    controller = PowerAssistController()
    slope = np.array(controller.twist_per_stick)
    here = np.array(step((0.01, 0.01, 0.1), controller=controller).intent)
    for axis in range(3):
        moved = [0.01, 0.01, 0.1]
        moved[axis] += 0.001
        there = np.array(step((moved[0], moved[1], moved[2]), controller=controller).intent)
        assert (there - here) / 0.001 == pytest.approx(slope[:, axis])


def test_the_force_is_that_of_a_hand_that_holds_the_published_stick() -> None:
    """A hand's spring of 200 N/m in y, 2 N·m/rad in theta, on the simulated stick until it rests;
    within an encoder count."""
    stick, centring = SimulatedStick().connect(240), Centring()
    hand = Hand((0.0, 0.03, 0.8), (200.0, 200.0, 2.0), (5.0, 5.0, 0.1), (0.1, 0.1, 0.001))
    for _ in range(1200):
        position = stick.advance(hand).position
    assert centring.y * position[1] == pytest.approx(200.0 * (0.03 - position[1]), abs=0.05)
    assert centring.theta * position[2] == pytest.approx(2.0 * (0.8 - position[2]), abs=0.02)


@pytest.mark.parametrize("way", [(-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
def test_a_robot_pushed_at_a_wall_stops_before_it(way: tuple[float, float]) -> None:
    """Full force from 0.6 m away: it runs on a little past the gap where the gain is zero."""
    controller = PowerAssistController()
    edge = 0.29 if way[0] else 0.19
    state, left = STILL, 0.6
    for _ in range(20 * 240):
        wall = posts((way[0] * (edge + left), way[1] * (edge + left)))
        position = (0.0414 * way[0], 0.0414 * way[1], 0.0)
        state = step(position, state, wall, controller=controller).state
        left -= (state.vx * way[0] + state.vy * way[1]) / 240
    assert left == pytest.approx(0.032, abs=0.002)
    assert abs(state.vx) + abs(state.vy) < 0.002
