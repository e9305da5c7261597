"""Wheels lag their command as a PID, a motor's limit and inertia make them: closed forms."""

from __future__ import annotations

from math import cos, exp, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import cont2discrete

from omnistudy.plants.wheel_servo import WheelServo

NO_INTEGRAL = 1e9
"""s, so long that the integral term does nothing."""


def speeds(servo: WheelServo, wanted: float, seconds: float, hz: int) -> list[float]:
    """The front left wheel's speed after every step of a commanded step from rest."""
    wheels = servo.start(hz)
    return [wheels.advance((wanted, 0.0, 0.0, 0.0))[0] for _ in range(round(seconds * hz))]


@pytest.mark.parametrize("t", [0.02, 0.05, 0.1, 0.2, 0.4])
def test_step_response_is_that_of_a_second_order_system(t: float) -> None:
    # (35 s + 400)/(s² + 36 s + 400): 0.35/0.01, 4/0.01 and (0.35 + 0.01)/0.01; natural frequency
    # 20 rad/s, damping 0.9
    sigma, damped, zero = 18.0, sqrt(400 - 18.0**2), 35.0
    by_hand = 1 - exp(-sigma * t) * (cos(damped * t) + (sigma - zero) / damped * sin(damped * t))
    hz = 20_000
    after = speeds(WheelServo(integral_time=NO_INTEGRAL), 1.0, t, hz)[-1]
    assert after == pytest.approx(by_hand, abs=2e-3)


def test_at_240_hz_it_is_the_sampled_loop_round_the_exact_wheel() -> None:
    servo, dt = WheelServo(integral_time=0.5), 1 / 240
    # the wheel alone, its torque held through a step: states position and speed
    system = (
        np.array([[0.0, 1.0], [0.0, -servo.friction / servo.inertia]]),
        np.array([[0.0], [1.0 / servo.inertia]]),
        np.eye(2),
        np.zeros((2, 1)),
    )
    a, b, *_ = cont2discrete(system, dt)
    wheel, position_wanted, summed, expected = np.zeros(2), 0.0, 0.0, []
    for _ in range(240):
        behind = position_wanted - wheel[0]
        torque = 4.0 * behind + 4.0 / 0.5 * summed + 0.35 * (2.0 - wheel[1])
        assert abs(torque) < servo.torque_limit
        summed += behind * dt
        position_wanted += 2.0 * dt
        wheel = a @ wheel + b[:, 0] * torque
        expected.append(wheel[1])
    assert speeds(servo, 2.0, 1.0, 240) == pytest.approx(expected, abs=1e-9)


def test_a_motor_at_its_limit_gives_no_more() -> None:
    # 1 N·m on 0.01 kg·m² with 0.01 N·m·s: 100·(1 - exp(-t)) rad/s, whatever is asked for
    after = speeds(WheelServo(), 1e4, 0.25, 240)
    assert after[-1] == pytest.approx(100 * (1 - exp(-0.25)))
    backwards = speeds(WheelServo(), -1e4, 0.25, 240)
    assert backwards[-1] == pytest.approx(-after[-1])


def test_the_integral_makes_up_the_way_that_friction_costs() -> None:
    # without it the wheel stays 0.1·5/4 rad behind at 5 rad/s
    lag = {}
    for name, reset in (("with", 0.2), ("without", NO_INTEGRAL)):
        after = speeds(WheelServo(friction=0.1, integral_time=reset), 5.0, 20.0, 240)
        lag[name] = 5.0 * 20.0 - (sum(after) - 2.5) / 240  # trapezia
        assert after[-1] == pytest.approx(5.0, abs=1e-6)
    assert lag["without"] == pytest.approx(0.1 * 5.0 / 4.0, abs=2e-3)
    assert abs(lag["with"]) < 2e-3


def test_what_the_limit_withheld_is_not_summed_up() -> None:
    # a second of what the weak motor cannot do, then a stop: the wheel catches up with the 10 rad
    # that it was told, and an integral that had wound up would carry it far beyond
    wheels = WheelServo(torque_limit=0.05, integral_time=0.5).start(240)
    way, farthest = 0.0, 0.0
    for step in range(20 * 240):
        way += wheels.advance((10.0 if step < 240 else 0.0, 0.0, 0.0, 0.0))[0] / 240
        farthest = max(farthest, way)
    assert way == pytest.approx(10.0, abs=0.05)
    assert farthest < 12.0


@given(st.tuples(*[st.floats(-20, 20)] * 4))
def test_each_wheel_minds_its_own_command(wanted: tuple[float, float, float, float]) -> None:
    together = WheelServo().start(240)
    alone = [WheelServo().start(240) for _ in wanted]
    for _ in range(10):
        turned = together.advance(wanted)
        single = [
            w.advance((speed, 0.0, 0.0, 0.0))[0] for w, speed in zip(alone, wanted, strict=True)
        ]
        assert turned == tuple(single)


def test_standing_wheels_stay() -> None:
    assert speeds(WheelServo(), 0.0, 0.1, 240) == [0.0] * 24
