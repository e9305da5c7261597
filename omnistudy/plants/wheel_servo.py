"""Four wheels with inertia and motors, each held to its commanded way by a PID on its encoder."""

from __future__ import annotations

from math import exp
from typing import Annotated

from omnistudy.plants.mecanum import WheelSpeeds
from omnistudy.registry import Model
from omnistudy.units import (
    KilogramSquareMetres,
    NewtonMetres,
    NewtonMetreSeconds,
    NewtonMetresPerRadian,
    Positive,
    Seconds,
)


class WheelServo(Model):
    """PID on a wheel's position, motor and wheel (Tyagi 2017, Fig. 2.8; every number is ours).

    The wanted position is the integral of the commanded speed; the encoder is taken as exact.
    """

    proportional: Annotated[NewtonMetresPerRadian, Positive] = 4.0
    """With the inertia a natural frequency of 20 rad/s."""
    integral_time: Annotated[Seconds, Positive] = 1.0
    """The integral term is the proportional one of the error summed over this time."""
    derivative: Annotated[NewtonMetreSeconds, Positive] = 0.35
    """With the friction a damping ratio of 0.9."""
    inertia: Annotated[KilogramSquareMetres, Positive] = 0.01
    """Of wheel, gear and rotor, and of the quarter of the robot's mass that rolls with them."""
    friction: Annotated[NewtonMetreSeconds, Positive] = 0.01
    """Torque per rad/s that turning takes."""
    torque_limit: Annotated[NewtonMetres, Positive] = 1.0
    """What a motor gives at the wheel."""

    def start(self, physics_hz: int) -> TurningWheels:
        """Give the wheels at rest."""
        return TurningWheels(self, 1.0 / physics_hz)


class TurningWheels:
    """The wheels of one trial; their torque is held through a step, their motion in it is exact."""

    def __init__(self, servo: WheelServo, dt: float) -> None:
        """Start at rest; dt in s."""
        decay = exp(-servo.friction * dt / servo.inertia)
        glide = servo.inertia / servo.friction * (1.0 - decay)
        self._numbers = (
            dt,
            servo.proportional,
            1.0 / servo.integral_time,
            servo.derivative,
            servo.torque_limit,
            1.0 / servo.friction,
            decay,
            glide,
        )
        self._wheels = [(0.0, 0.0, 0.0)] * 4

    def advance(self, wanted: WheelSpeeds) -> WheelSpeeds:
        """Let one step pass with these speeds commanded; give the wheels' own, rad/s."""
        self._wheels = [
            self._turned(wheel, speed) for wheel, speed in zip(self._wheels, wanted, strict=True)
        ]
        (_, _, fl), (_, _, fr), (_, _, rl), (_, _, rr) = self._wheels
        return fl, fr, rl, rr

    def _turned(
        self, wheel: tuple[float, float, float], wanted: float
    ) -> tuple[float, float, float]:
        """Move on a wheel's position error in rad, the error's integral in rad·s, and its speed."""
        dt, gain, reset, rate_gain, limit, mobility, decay, glide = self._numbers
        behind, summed, speed = wheel
        torque = gain * (behind + reset * summed) + rate_gain * (wanted - speed)
        if -limit < torque < limit:
            summed += behind * dt
        else:
            torque = limit if torque > 0.0 else -limit
        final = torque * mobility
        behind += (wanted - final) * dt - (speed - final) * glide
        return behind, summed, final + (speed - final) * decay
