"""The thesis's 3-DOF stick as a simulated mechanism with its firmware, in a hand or alone."""

from __future__ import annotations

from math import inf, sin
from typing import Annotated, Literal

from pydantic import Field

from omnistudy.channel import Channel
from omnistudy.devices.device import Device, DeviceState, Hand, RunningDevice
from omnistudy.devices.mechanics import HeldStep, held_step
from omnistudy.devices.motor import motor_counts, motor_counts_as_published
from omnistudy.devices.stick_scale import StickScale
from omnistudy.geometry import NO_FORCE, ForceField
from omnistudy.registry import Model
from omnistudy.units import NewtonMetres, Newtons, Positive, Ratio

DEGREES_PER_COUNT = 360.0 / 1440.0
"""Motor degrees per quadrature count (US Digital E4P, 360 cycles a turn)."""


class Axis(Model):
    """One motor of the stick, in the firmware's units (Tyagi 2017, eq. 3.2, App. B; omni.md 2).

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
    """Stick, firmware and hand, advanced in lockstep (Tyagi 2017, ch. 2-3; omni.md 2)."""

    kind: Literal["simulated_stick"] = "simulated_stick"
    scale: StickScale = StickScale()
    x: Axis = Axis(gravity=100.0)
    y: Axis = Axis(gravity=70.0)
    theta: Axis = Axis(proportional=1.9 * 0.7, derivative=1.1 * 0.042, travel=1440.0)
    force_limit: Annotated[Newtons, Positive] = 13.5
    """At the handle for 255 PWM counts, in x and y."""
    torque_limit: Annotated[NewtonMetres, Positive] = 4.4
    """At the handle for 255 PWM counts; published, though 15 x 85.6 mN·m is 1.28 N·m."""
    ticks_per_step: Annotated[int, Field(ge=1, le=16)] = 2
    """Firmware ticks in one physics step: 480 Hz at 240 Hz physics."""
    as_published: bool = False
    """True drives both pins of a motor pair as the thesis's firmware does."""

    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the stick at rest in its centre."""
        return _RunningStick(self, physics_hz)


class _AxisState:
    """One axis in motion, SI at the handle; what a tick needs lies ready as floats."""

    __slots__ = (
        "centring_damping",
        "centring_stiffness",
        "counts_per_newton",
        "damping",
        "force",
        "gravity",
        "lever",
        "limit",
        "mass",
        "metres_per_count",
        "position",
        "rate",
        "step",
        "travel",
    )  # fmt: skip

    def __init__(self, axis: Axis, limit: float, metres_per_count: float, lever: float) -> None:
        metres_per_degree = metres_per_count / DEGREES_PER_COUNT
        self.counts_per_newton = 255.0 / limit
        self.limit = limit
        self.mass = 1.0 / (self.counts_per_newton * axis.gain * metres_per_degree)
        self.damping = axis.pole * self.mass
        self.centring_stiffness = axis.proportional / (self.counts_per_newton * metres_per_degree)
        self.centring_damping = axis.derivative / (self.counts_per_newton * metres_per_degree)
        self.gravity = axis.gravity / self.counts_per_newton
        self.lever = lever
        self.metres_per_count = metres_per_count
        self.travel = axis.travel * metres_per_count
        self.position = 0.0
        self.rate = 0.0
        self.force = 0.0
        self.step: HeldStep | None = None


class _RunningStick(RunningDevice):
    _channels = (
        Channel("motor_x", "N", "motor force at the handle after clipping, with centring"),
        Channel("motor_y", "N", "motor force at the handle after clipping, with centring"),
        Channel("motor_theta", "N·m", "motor torque at the handle after clipping, with centring"),
    )

    def __init__(self, stick: SimulatedStick, physics_hz: int) -> None:
        scale = stick.scale
        self._dt = 1.0 / (physics_hz * stick.ticks_per_step)
        self._ticks = stick.ticks_per_step
        self._as_published = stick.as_published
        per_count, turn = scale.metres_per_count, scale.radians_per_count
        self._axes = (
            _AxisState(stick.x, stick.force_limit, per_count, scale.lever),
            _AxisState(stick.y, stick.force_limit, per_count, scale.lever),
            _AxisState(stick.theta, stick.torque_limit, turn, inf),
        )
        self.axes = (
            Channel("stick_x", "m", "handle's travel, forward", per_count),
            Channel("stick_y", "m", "handle's travel, left", per_count),
            Channel("stick_theta", "rad", "handle's twist, counter-clockwise", turn),
        )
        self._hand: Hand | None = None
        self._field = NO_FORCE
        self._offset = [0.0, 0.0, 0.0]
        self._offset_step = [0.0, 0.0, 0.0]
        self._ramp = 0
        self._since_field = physics_hz * stick.ticks_per_step
        self._valid = 0

    @property
    def channels(self) -> tuple[Channel, ...]:
        return self._channels

    def values(self) -> tuple[float, ...]:
        x, y, theta = self._axes
        return (x.force, y.force, theta.force)

    def render(self, field: ForceField) -> None:
        """Take a field; its wrench is ramped over one law period so that the hand feels no step."""
        self._exchange(field)
        about, wrench, stiffness = field.about, field.wrench, field.stiffness
        ticks = max(1, min(self._since_field, round(field.valid_for / self._dt)))
        for i, row in enumerate(stiffness):
            target = wrench[i] + row[0] * about[0] + row[1] * about[1] + row[2] * about[2]
            self._offset_step[i] = (target - self._offset[i]) / ticks
        self._ramp = ticks
        self._since_field = 0
        self._valid = max(1, round(field.valid_for / self._dt))

    def _exchange(self, field: ForceField) -> None:
        """Change stiffness and damping without a step: the offset takes up the difference."""
        old = self._field
        self._field = field
        if old.stiffness == field.stiffness and old.damping == field.damping:
            return
        for i in range(3):
            for j, axis in enumerate(self._axes):
                self._offset[i] += (field.stiffness[i][j] - old.stiffness[i][j]) * axis.position + (
                    field.damping[i][j] - old.damping[i][j]
                ) * axis.rate

    def advance(self, hand: Hand) -> DeviceState:
        """Let the firmware tick and the handle move; give whole encoder counts in SI."""
        if hand.stiffness[0] == inf:
            self._prescribe(hand)
        else:
            if self._hand is None or hand[1:] != self._hand[1:]:
                self._hold(hand)
            self._hand = hand
            for _ in range(self._ticks):
                self._tick(hand)
        x, y, theta = self._axes
        cx, cy, ct = x.metres_per_count, y.metres_per_count, theta.metres_per_count
        return DeviceState(
            (round(x.position / cx) * cx, round(y.position / cy) * cy,
             round(theta.position / ct) * ct),
            (round(x.rate / cx) * cx, round(y.rate / cy) * cy, round(theta.rate / ct) * ct),
        )  # fmt: skip

    def _hold(self, hand: Hand) -> None:
        for i, axis in enumerate(self._axes):
            axis.step = held_step(
                axis.mass + hand.mass[i],
                axis.damping + hand.damping[i],
                hand.stiffness[i],
                self._dt,
            )

    def _prescribe(self, hand: Hand) -> None:
        self._hand = hand
        for axis, reference in zip(self._axes, hand.reference, strict=True):
            position = max(-axis.travel, min(axis.travel, reference))
            axis.rate = (position - axis.position) / (self._dt * self._ticks)
            axis.position = position

    def _tick(self, hand: Hand) -> None:
        self._since_field += 1
        offset = self._offset
        if self._ramp:
            self._ramp -= 1
            step = self._offset_step
            offset[0] += step[0]
            offset[1] += step[1]
            offset[2] += step[2]
        if self._valid:
            self._valid -= 1
            if not self._valid:
                self._go_stale()
        x, y, theta = self._axes
        qx, qy, qt = x.position, y.position, theta.position
        vx, vy, vt = x.rate, y.rate, theta.rate
        stiffness, damping = self._field.stiffness, self._field.damping
        reference, hand_stiffness = hand.reference, hand.stiffness
        for i, axis in enumerate(self._axes):
            k, d = stiffness[i], damping[i]
            feedback = (
                offset[i]
                - k[0] * qx - k[1] * qy - k[2] * qt
                - d[0] * vx - d[1] * vy - d[2] * vt
            )  # fmt: skip
            self._move(axis, feedback, reference[i] * hand_stiffness[i])

    def _go_stale(self) -> None:
        """Fade to no force over one period of validity (a force is bounded in time, too)."""
        ticks = max(1, round(self._field.valid_for / self._dt))
        self._exchange(NO_FORCE)
        self._offset_step = [-value / ticks for value in self._offset]
        self._ramp = ticks

    def _move(self, axis: _AxisState, feedback: float, pull: float) -> None:
        position, rate = axis.position, axis.rate
        centring = -axis.centring_stiffness * position - axis.centring_damping * rate
        weight = axis.gravity * sin(position / axis.lever) if axis.gravity else 0.0
        if self._as_published:
            scale = axis.counts_per_newton
            force = (
                motor_counts_as_published(feedback * scale, centring * scale, -weight * scale)
                / scale
            )
        else:
            force = motor_counts(feedback, centring, -weight, axis.limit)
        axis.force = force
        step = axis.step
        assert step is not None
        push = force + weight + pull
        moved = step.qq * position + step.qv * rate + step.qu * push
        if abs(moved) >= axis.travel:
            axis.position = axis.travel if moved > 0.0 else -axis.travel
            axis.rate = 0.0
        else:
            axis.position = moved
            axis.rate = step.vq * position + step.vv * rate + step.vu * push
