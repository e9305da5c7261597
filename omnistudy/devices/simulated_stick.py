"""The thesis's 3-DOF stick as a simulated mechanism with its firmware, in a hand or alone."""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from omnistudy.devices.device import Device, RunningDevice
from omnistudy.devices.stick_scale import (
    FORCE_AT_FULL_DUTY,
    TORQUE_AT_FULL_DUTY,
    StickScale,
)
from omnistudy.registry import Model
from omnistudy.units import NewtonMetres, Newtons, Positive, Ratio

DEGREES_PER_COUNT = 360.0 / 1440.0
"""Motor degrees per quadrature count (US Digital E4P, 360 cycles a turn)."""


class Axis(Model):
    """One motor of the stick, in the firmware's units (Tyagi 2017, eq. 3.2, App. B).

    psi/u = gain/(s(s + pole)): psi in motor degrees, u in PWM counts.
    """

    gain: Annotated[Ratio, Positive] = 899.0
    """Motor acceleration, degrees/s² per PWM count (eq. 3.2)."""
    pole: Annotated[Ratio, Positive] = 17.2
    """Friction over inertia, 1/s (eq. 3.2)."""
    proportional: Annotated[Ratio, Field(ge=0)] = 0.7
    """Centring, PWM counts per motor degree."""
    derivative: Annotated[Ratio, Field(ge=0)] = 0.042
    """Centring, PWM counts per motor degree/s (42 per degree/ms)."""
    gravity: Annotated[Ratio, Field(ge=0)] = 0.0
    """Weight of the handle and its compensation, PWM counts times sin(handle angle) (eq. 2.1)."""
    travel: Annotated[Ratio, Positive] = 300.0
    """Mechanical stop, encoder counts either way."""


class SimulatedStick(Device):
    """Stick, firmware and hand, advanced in lockstep (Tyagi 2017, ch. 2-3)."""

    kind: Literal["simulated_stick"] = "simulated_stick"
    scale: StickScale = StickScale()
    x: Axis = Axis(gravity=100.0)
    y: Axis = Axis(gravity=70.0)
    theta: Axis = Axis(proportional=1.9 * 0.7, derivative=1.1 * 0.042, travel=1440.0)
    force_limit: Annotated[Newtons, Positive] = FORCE_AT_FULL_DUTY
    """At the handle for 255 PWM counts, in x and y."""
    torque_limit: Annotated[NewtonMetres, Positive] = TORQUE_AT_FULL_DUTY
    """At the handle for 255 PWM counts; published, though 15 x 85.6 mN·m is 1.28 N·m."""
    ticks_per_step: Annotated[int, Field(ge=1, le=16)] = 2
    """Firmware ticks in one physics step: 480 Hz at 240 Hz physics."""
    as_published: bool = False
    """True drives both pins of a motor pair as the thesis's firmware does."""

    @property
    def stops(self) -> tuple[int, int, int]:
        """Mechanical stops, encoder counts either way."""
        return (round(self.x.travel), round(self.y.travel), round(self.theta.travel))

    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the stick at rest in its centre."""
        from omnistudy.devices.stick_in_motion import StickInMotion

        return StickInMotion(self, physics_hz)

    def own_force(
        self, position: NDArray[np.float64], rate: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Give centring and gravity compensation, clipped as the motors clip them."""
        from omnistudy.devices.stick_in_motion import own_force

        return own_force(self, position, rate)
