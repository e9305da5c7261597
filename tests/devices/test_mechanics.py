"""A mass, spring and damper under a held force moves as the textbook says."""

from math import cos, exp, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.mechanics import HeldStep, held_step

DT = 1 / 480


def after(step: HeldStep, q: float, v: float, u: float, times: int = 1) -> tuple[float, float]:
    for _ in range(times):
        q, v = (
            step.qq * q + step.qv * v + step.qu * u,
            step.vq * q + step.vv * v + step.vu * u,
        )
    return q, v


def test_a_free_mass_is_thrown_and_pushed() -> None:
    q, v = after(held_step(2.0, 0.0, 0.0, 0.5), 1.0, 3.0, 4.0)
    assert q == pytest.approx(1.0 + 3.0 * 0.5 + 0.5 * (4.0 / 2.0) * 0.25)
    assert v == pytest.approx(3.0 + (4.0 / 2.0) * 0.5)


def test_an_undamped_spring_swings() -> None:
    # m = 0.5 kg, k = 50 N/m: 10 rad/s about the place u/k = 0.1 m where the force holds it
    q, v = after(held_step(0.5, 0.0, 50.0, 0.12), 0.3, -1.0, 5.0)
    assert q == pytest.approx(0.1 + 0.2 * cos(1.2) - 0.1 * sin(1.2))
    assert v == pytest.approx(-10 * 0.2 * sin(1.2) - 1.0 * cos(1.2))


def test_an_overdamped_spring_creeps_back() -> None:
    # m = 1, b = 5, k = 6: roots -2 and -3; from q = 1 at rest q = 3e^-2t - 2e^-3t
    q, v = after(held_step(1.0, 5.0, 6.0, 0.4), 1.0, 0.0, 0.0)
    assert q == pytest.approx(3 * exp(-0.8) - 2 * exp(-1.2))
    assert v == pytest.approx(-6 * exp(-0.8) + 6 * exp(-1.2))


def test_friction_alone_lets_it_run_out() -> None:
    q, v = after(held_step(2.0, 6.0, 0.0, 0.7), 0.0, 1.0, 0.0)
    assert v == pytest.approx(exp(-2.1))
    assert q == pytest.approx((1 - exp(-2.1)) / 3)


def test_a_very_stiff_arm_is_no_trouble() -> None:
    # 1e6 N/m on 0.9 kg: 1054 rad/s, 2.2 rad in one tick, zeta 0.7
    mass, stiffness = 0.9, 1e6
    damping = 1.4 * sqrt(stiffness * mass)
    q, _ = after(held_step(mass, damping, stiffness, DT), 0.0, 0.0, 2000.0, times=20)
    assert q == pytest.approx(0.002, rel=1e-6)


plain = st.floats(-10.0, 10.0)


@given(
    mass=st.floats(0.01, 10.0),
    damping=st.floats(0.0, 100.0),
    stiffness=st.floats(0.0, 1e4),
    first=st.floats(1e-4, 0.05),
    second=st.floats(1e-4, 0.05),
    q=plain,
    v=plain,
    u=plain,
)
def test_two_steps_are_one_long_step(
    mass: float,
    damping: float,
    stiffness: float,
    first: float,
    second: float,
    q: float,
    v: float,
    u: float,
) -> None:
    in_two = after(
        held_step(mass, damping, stiffness, second),
        *after(held_step(mass, damping, stiffness, first), q, v, u),
        u,
    )
    in_one = after(held_step(mass, damping, stiffness, first + second), q, v, u)
    scale = 1.0 + abs(q) + abs(v) + abs(u) / mass
    swing = 1.0 + sqrt(stiffness / mass)
    assert in_two[0] == pytest.approx(in_one[0], abs=1e-9 * scale)
    assert in_two[1] == pytest.approx(in_one[1], abs=1e-9 * scale * swing)
