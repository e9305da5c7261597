"""The stick in a hand, alone and under feedback: the mechanism that the thesis identified."""

from __future__ import annotations

from math import inf, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omnistudy.devices import Hand, RunningDevice
from omnistudy.devices.simulated_stick import Axis, SimulatedStick
from omnistudy.geometry import ZERO_MATRIX, ForceField, Matrix3, PlanarWrench

Three = tuple[float, float, float]

ZERO = (0.0, 0.0, 0.0)
NOBODY = Hand(ZERO, ZERO, ZERO, ZERO)
COUNT = 0.095 * pi / 180 / 12
"""m at the handle for one encoder count in x and y: 12 counts a degree of a 95 mm handle."""
TURN_COUNT = pi / 180 / 4
LIMP = Axis(proportional=0.0, derivative=0.0)
"""An axis that nothing centres, so that what is felt is the feedback alone."""


def prescribed(x: float, y: float = 0.0, theta: float = 0.0) -> Hand:
    return Hand((x, y, theta), (inf, inf, inf), ZERO, ZERO)


def clamped(x: float, y: float = 0.0, theta: float = 0.0) -> Hand:
    """A hand so stiff that no motor moves it, yet the firmware goes on ticking."""
    return Hand((x, y, theta), (1e7, 1e7, 1e7), (1e4, 1e4, 1e4), (1.0, 1.0, 1.0))


def pushing(newtons: float, axis: int) -> Hand:
    """A hand that pushes with the same force wherever the stick is."""
    reference = tuple(newtons * 1e9 if i == axis else 0.0 for i in range(3))
    return Hand(reference, (1e-9, 1e-9, 1e-9), ZERO, ZERO)


def deflected(stick: SimulatedStick, place: Three, physics_hz: int) -> RunningDevice:
    """A stick that rests at a place and has just been let go."""
    device = stick.connect(physics_hz)
    device.advance(prescribed(*place))
    device.advance(prescribed(*place))
    return device


def polynomial(stick: SimulatedStick, axis: int, place: Three) -> tuple[float, float]:
    """Identify (a, b) of s² + a·s + b from the free response to a deflection.

    The motion obeys q' - q'(0) + a·(q - q(0)) + b·∫q = 0 at every instant.
    """
    hz, steps = 1000, 300
    device = deflected(stick, place, hz)
    states = [device.advance(NOBODY) for _ in range(steps)]
    q = np.array([place[axis], *(state.position[axis] for state in states)])
    v = np.array([0.0, *(state.rate[axis] for state in states)])
    area = np.concatenate(([0.0], np.cumsum((q[1:] + q[:-1]) / 2 / hz)))
    (a, b), *_ = np.linalg.lstsq(np.column_stack((q - q[0], area)), -(v - v[0]), rcond=None)
    return float(a), float(b)


FAST = 16
"""Firmware ticks in a step of 1 ms: nearly continuous, as the published equations are."""


@pytest.mark.parametrize("axis", [0, 1])
def test_inner_loop_polynomial_of_the_thesis(axis: int) -> None:
    # s² + (17.2 + 899·0.042)s + 899·0.7 = s² + 54.96 s + 629.3 (Tyagi 2017, eq. 3.3)
    place = (0.04, 0.0, 0.0) if axis == 0 else (0.0, 0.04, 0.0)
    a, b = polynomial(SimulatedStick(ticks_per_step=FAST), axis, place)
    assert a == pytest.approx(54.96, rel=0.01)
    assert b == pytest.approx(629.3, rel=0.01)


def test_inner_loop_of_the_twist_has_its_own_gains() -> None:
    # 1.9·Kp and 1.1·Kd: s² + (17.2 + 899·0.0462)s + 899·1.33
    a, b = polynomial(SimulatedStick(ticks_per_step=FAST), 2, (0.0, 0.0, 1.0))
    assert a == pytest.approx(58.73, rel=0.01)
    assert b == pytest.approx(1195.7, rel=0.01)


def test_under_proportional_control_it_swings_as_identified() -> None:
    # omega_n 25.1 rad/s and zeta 0.343 at P = 0.7 (Tyagi 2017, eq. 3.2)
    stick = SimulatedStick(ticks_per_step=FAST, x=Axis(derivative=0.0))
    a, b = polynomial(stick, 0, (0.04, 0.0, 0.0))
    assert sqrt(b) == pytest.approx(25.1, rel=0.01)
    assert a / (2 * sqrt(b)) == pytest.approx(0.343, rel=0.02)


def test_a_hand_feels_67_newtons_a_metre_of_centring() -> None:
    device = SimulatedStick().connect(240)
    for _ in range(240):
        state = device.advance(pushing(1.0, axis=0))
    assert 1.0 / state.position[0] == pytest.approx(66.9, rel=0.01)


def test_moving_mass_and_friction_at_the_handle() -> None:
    # 0.106 kg and 1.83 N·s/m: under 0.1 N towards 55 mm/s, with a time constant of 58 ms
    device = SimulatedStick(x=LIMP, ticks_per_step=FAST).connect(1000)
    rates = [device.advance(pushing(0.1, axis=0)).rate[0] for _ in range(500)]
    assert rates[-1] == pytest.approx(0.1 / 1.83, rel=0.01)
    assert rates[9] == pytest.approx(0.1 / 0.106 * 0.01, rel=0.1)
    assert rates[57] / rates[-1] == pytest.approx(1 - np.exp(-1), rel=0.02)


def test_derivative_gain_is_4_newtons_a_metre_per_second() -> None:
    with_derivative = SimulatedStick(x=Axis(proportional=0.0), ticks_per_step=FAST).connect(1000)
    for _ in range(300):
        state = with_derivative.advance(pushing(0.1, axis=0))
    assert 0.1 / state.rate[0] - 1.83 == pytest.approx(4.02, rel=0.01)


def test_travel_and_newtons_of_one_count_of_duty() -> None:
    device = SimulatedStick().connect(240)
    for _ in range(240):
        state = device.advance(pushing(12.0, axis=0))
    assert state.position[0] == pytest.approx(0.0415, abs=0.0001)
    assert state.position[0] == pytest.approx(300 * COUNT)
    # 75 motor degrees · 0.7 PWM of centring, and 100·sin 25° PWM that carry the handle
    assert device.values()[0] == pytest.approx(-(52.5 + 42.26) * 0.0529, rel=0.001)


def test_gravity_and_its_compensation_cancel() -> None:
    tall = SimulatedStick(x=Axis(gravity=100.0))
    light = SimulatedStick(x=Axis(gravity=0.0))
    paths = [
        [device.advance(NOBODY).position[0] for _ in range(60)]
        for device in (deflected(tall, (0.03, 0, 0), 240), deflected(light, (0.03, 0, 0), 240))
    ]
    assert np.allclose(paths[0], paths[1], rtol=0, atol=1.01 * COUNT)


@given(
    st.floats(-0.05, 0.05),
    st.floats(-0.05, 0.05),
    st.floats(-7.0, 7.0),
)
def test_position_comes_in_whole_encoder_counts(x: float, y: float, theta: float) -> None:
    state = SimulatedStick().connect(240).advance(prescribed(x, y, theta))
    for value, wanted, count, travel in zip(
        state.position, (x, y, theta), (COUNT, COUNT, TURN_COUNT), (300, 300, 1440), strict=True
    ):
        counts = value / count
        assert counts == pytest.approx(round(counts), abs=1e-9)
        held = max(-travel * count, min(travel * count, wanted))
        assert abs(value - held) <= 0.5001 * count


def test_a_prescribed_hand_sets_position_and_rate() -> None:
    device = SimulatedStick().connect(240)
    device.advance(prescribed(0.0))
    state = device.advance(prescribed(0.01))
    assert state.position[0] == pytest.approx(0.01, abs=COUNT)
    assert state.rate[0] == pytest.approx(0.01 * 240, abs=COUNT)


WRENCH = PlanarWrench(1.0, -2.0, 0.3)
ABOUT = (0.01, -0.02, 0.1)
STIFFNESS = ((20.0, 3.0, 0.5), (-4.0, 30.0, 0.2), (1.0, -2.0, 0.8))
DAMPING = ((2.0, 0.3, 0.1), (0.4, 3.0, -0.2), (0.05, 0.1, 0.6))
Q = (50 * COUNT, -40 * COUNT, 30 * TURN_COUNT)
V = (0.1, -0.2, 0.5)


def diagonal(matrix: Matrix3) -> Matrix3:
    (a, _, _), (_, b, _), (_, _, c) = matrix
    return ((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c))


@pytest.mark.parametrize(
    ("stiffness", "damping"),
    [
        (STIFFNESS, DAMPING),
        (diagonal(STIFFNESS), diagonal(DAMPING)),
        (STIFFNESS, ZERO_MATRIX),
        (ZERO_MATRIX, DAMPING),
    ],
)
def test_stiffness_and_damping_are_rendered_whole_and_with_their_signs(
    stiffness: Matrix3, damping: Matrix3
) -> None:
    # F = wrench - K·(q - about) - D·q', every entry of both 3x3 matrices felt
    stick = SimulatedStick(x=LIMP, y=LIMP, theta=LIMP, ticks_per_step=1)
    device = stick.connect(480)
    device.render(ForceField(WRENCH, ABOUT, stiffness, damping, valid_for=10.0))
    for _ in range(4000):
        device.advance(clamped(*Q))
    before = tuple(q - v / 480 for q, v in zip(Q, V, strict=True))
    device.advance(prescribed(*before))
    device.advance(prescribed(*Q))
    device.advance(NOBODY)
    expected = (
        np.array(WRENCH)
        - np.array(stiffness) @ (np.array(Q) - np.array(ABOUT))
        - np.array(damping) @ np.array(V)
    )
    assert device.values() == pytest.approx(tuple(expected), abs=1e-4)


def felt(device: RunningDevice, hand: Hand, ticks: int) -> list[Three]:
    """Motor forces tick by tick."""
    forces = []
    for _ in range(ticks):
        device.advance(hand)
        forces.append(device.values())
    return forces  # type: ignore[return-value]


def test_a_new_field_is_felt_without_a_step() -> None:
    # from one wall to another: force, stiffness and damping all change at once, at 48 Hz
    stick = SimulatedStick(x=LIMP, y=LIMP, theta=LIMP, ticks_per_step=1)
    device, hand = stick.connect(480), clamped(*Q)
    fields = (
        ForceField(PlanarWrench(2.0, 0.0, 0.0), Q),
        ForceField(PlanarWrench(-3.0, 4.0, 0.5), Q, STIFFNESS, DAMPING),
    )
    felt(device, hand, 480)
    forces: list[Three] = []
    for number in range(20):
        device.render(fields[number % 2])
        forces += felt(device, hand, 10)
    settled = np.array(forces)[50:]
    largest = np.abs(np.diff(settled, axis=0)).max(axis=0)
    assert (largest <= np.array([5.0, 4.0, 0.5]) / 10 * 1.01).all()
    assert settled[9] == pytest.approx((-3.0, 4.0, 0.5), abs=1e-4)
    assert settled[19] == pytest.approx((2.0, 0.0, 0.0), abs=1e-4)


def test_the_first_field_comes_without_a_step_too() -> None:
    device = SimulatedStick(x=LIMP, ticks_per_step=1).connect(480)
    device.render(ForceField(PlanarWrench(10.0, 0.0, 0.0)))
    assert 0.0 < felt(device, clamped(0.0), 1)[0][0] < 0.5


def test_a_stale_field_fades_to_nothing() -> None:
    # valid for 0.1 s; then it goes down over another 0.1 s and never comes back
    stick = SimulatedStick(x=LIMP, y=LIMP, theta=LIMP, ticks_per_step=1)
    device, hand = stick.connect(480), clamped(*Q)
    field = ForceField(PlanarWrench(4.0, -2.0, 0.4), ABOUT, STIFFNESS, DAMPING, valid_for=0.1)
    for _ in range(20):
        device.render(field)
        forces = felt(device, hand, 10)
    full = np.array(forces[-1])
    assert np.abs(full).min() > 0.1
    forces = felt(device, hand, 38 + 48 + 10)
    assert forces[36] == pytest.approx(full, abs=1e-4)
    steps = np.diff(np.array(forces), axis=0)
    assert (np.abs(steps) <= np.abs(full) / 48 * 1.01 + 1e-9).all()
    assert forces[-1] == pytest.approx(ZERO, abs=1e-12)


entry = st.floats(-1e5, 1e5)
row = st.tuples(entry, entry, entry)
fields = st.builds(
    ForceField,
    wrench=st.builds(PlanarWrench, entry, entry, entry),
    about=st.tuples(*(st.floats(-1.0, 1.0),) * 3),
    stiffness=st.tuples(row, row, row),
    damping=st.tuples(row, row, row),
    valid_for=st.floats(0.0, 1.0),
)


@settings(max_examples=60)
@given(st.lists(fields, min_size=1, max_size=4), st.booleans())
def test_force_is_bounded_whatever_field_arrives(
    arriving: list[ForceField], as_published: bool
) -> None:
    device = SimulatedStick(as_published=as_published).connect(240)
    for field in arriving:
        device.render(field)
        for _ in range(5):
            state = device.advance(Hand((0.02, 0, 0), (200, 200, 2), (20, 20, 0.1), (1, 1, 0.1)))
            fx, fy, tau = device.values()
            assert abs(fx) <= 13.5 + 1e-9
            assert abs(fy) <= 13.5 + 1e-9
            assert abs(tau) <= 4.4 + 1e-9
            assert abs(state.position[0]) <= 300.001 * COUNT


def test_the_published_pins_are_driven_when_asked_for() -> None:
    # at the stop centring takes 52.5 PWM back; 300 PWM of feedback is clipped on its own pin
    force = 300 * 13.5 / 255
    net = {}
    for as_published in (False, True):
        stick = SimulatedStick(as_published=as_published, x=Axis(), ticks_per_step=1)
        device = stick.connect(480)
        device.render(ForceField(PlanarWrench(force, 0.0, 0.0), valid_for=10.0))
        net[as_published] = felt(device, clamped(300 * COUNT), 4000)[-1][0] * 255 / 13.5
    assert net[False] == pytest.approx(300 - 52.5, abs=0.01)
    assert net[True] == pytest.approx(255 - 52.5, abs=0.01)
