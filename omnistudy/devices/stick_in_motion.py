"""The simulated stick during one trial: firmware ticks, mechanism, hand."""

from __future__ import annotations

from math import inf, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import Channel
from omnistudy.devices.device import DeviceState, Hand, RunningDevice
from omnistudy.devices.mechanics import HeldStep, held_step
from omnistudy.devices.motor import motor_counts_as_published
from omnistudy.devices.simulated_stick import DEGREES_PER_COUNT, Axis, SimulatedStick
from omnistudy.devices.stick_scale import FULL_DUTY
from omnistudy.geometry import NO_FORCE, ForceField


class _Mechanism(NamedTuple):
    """One axis in SI at the handle: N, N/m, N·s/m, m (twist: N·m, N·m/rad, N·m·s, rad)."""

    limit: float
    travel: float
    centring_stiffness: float
    centring_damping: float
    gravity: float
    lever: float
    mass: float
    damping: float
    counts_per_newton: float


def _in_si(axis: Axis, limit: float, per_count: float, lever: float) -> _Mechanism:
    per_degree = per_count / DEGREES_PER_COUNT
    counts_per_newton = FULL_DUTY / limit
    mass = 1.0 / (counts_per_newton * axis.gain * per_degree)
    return _Mechanism(
        limit=limit,
        travel=axis.travel * per_count,
        centring_stiffness=axis.proportional / (counts_per_newton * per_degree),
        centring_damping=axis.derivative / (counts_per_newton * per_degree),
        gravity=axis.gravity / counts_per_newton,
        lever=lever,
        mass=mass,
        damping=axis.pole * mass,
        counts_per_newton=counts_per_newton,
    )


def _mechanisms(stick: SimulatedStick) -> tuple[_Mechanism, _Mechanism, _Mechanism]:
    scale = stick.scale
    count, turn = scale.metres_per_count, scale.radians_per_count
    return (
        _in_si(stick.x, stick.force_limit, count, scale.lever),
        _in_si(stick.y, stick.force_limit, count, scale.lever),
        _in_si(stick.theta, stick.torque_limit, turn, inf),
    )


def own_force(
    stick: SimulatedStick, position: NDArray[np.float64], rate: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Give the motor force (n, 3) in N and N·m without a field, at positions and rates (n, 3)."""
    force = np.empty_like(position)
    for i, mechanism in enumerate(_mechanisms(stick)):
        centring = (
            -mechanism.centring_stiffness * position[:, i] - mechanism.centring_damping * rate[:, i]
        )
        weight = mechanism.gravity * np.sin(position[:, i] / mechanism.lever)
        if stick.as_published:
            scale = mechanism.counts_per_newton
            for row, (push, heavy) in enumerate(zip(centring, weight, strict=True)):
                force[row, i] = motor_counts_as_published(0.0, push * scale, -heavy * scale) / scale
        else:
            force[:, i] = np.clip(centring - weight, -mechanism.limit, mechanism.limit)
    return force


class StickInMotion(RunningDevice):
    """Position and rate of three axes; `_tick` is the innermost loop of a trial and kept flat."""

    forces = (True, True, True)
    wrench = "clipped"
    channels = (
        Channel("motor_x", "N", "motor force at the handle after clipping, with centring"),
        Channel("motor_y", "N", "motor force at the handle after clipping, with centring"),
        Channel("motor_theta", "N·m", "motor torque at the handle after clipping, with centring"),
    )

    def __init__(self, stick: SimulatedStick, physics_hz: int) -> None:
        scale = stick.scale
        count, turn = scale.metres_per_count, scale.radians_per_count
        self._dt = 1.0 / (physics_hz * stick.ticks_per_step)
        self._ticks = stick.ticks_per_step
        self._as_published = stick.as_published
        self._mechanisms = _mechanisms(stick)
        self.axes = (
            Channel("stick_x", "m", "handle's travel, forward", count),
            Channel("stick_y", "m", "handle's travel, left", count),
            Channel("stick_theta", "rad", "handle's twist, counter-clockwise", turn),
        )
        self._counts = (count, count, turn)
        self._position = [0.0, 0.0, 0.0]
        self._rate = [0.0, 0.0, 0.0]
        self._force = [0.0, 0.0, 0.0]
        self._held: tuple[object, ...] | None = None
        self._steps: tuple[HeldStep, ...] = ()
        self._field = NO_FORCE
        self._coupled = False
        self._offset = [0.0, 0.0, 0.0]
        self._offset_step = [0.0, 0.0, 0.0]
        self._ramp = 0
        self._since_field = physics_hz * stick.ticks_per_step
        self._valid = 0

    def values(self) -> tuple[float, ...]:
        """Give the motor forces of the last tick."""
        x, y, theta = self._force
        return (x, y, theta)

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
        self._coupled = any(
            row[j] != 0.0
            for matrix in (field.stiffness, field.damping)
            for i, row in enumerate(matrix)
            for j in range(3)
            if i != j
        )
        for i in range(3):
            for j in range(3):
                self._offset[i] += (field.stiffness[i][j] - old.stiffness[i][j]) * self._position[
                    j
                ] + (field.damping[i][j] - old.damping[i][j]) * self._rate[j]

    def advance(self, hand: Hand) -> DeviceState:
        """Let the firmware tick and the handle move; give whole encoder counts in SI."""
        if hand.stiffness[0] == inf:
            self._prescribe(hand)
        else:
            if hand[1:] != self._held:
                self._hold(hand)
            pull = [k * q for k, q in zip(hand.stiffness, hand.reference, strict=True)]
            for _ in range(self._ticks):
                self._tick(pull)
        count, _, turn = self._counts
        x, y, theta = self._position
        vx, vy, omega = self._rate
        return DeviceState(
            (round(x / count) * count, round(y / count) * count, round(theta / turn) * turn),
            (round(vx / count) * count, round(vy / count) * count, round(omega / turn) * turn),
        )

    def _hold(self, hand: Hand) -> None:
        self._held = hand[1:]
        self._steps = tuple(
            held_step(
                mechanism.mass + hand.mass[i],
                mechanism.damping + hand.damping[i],
                hand.stiffness[i],
                self._dt,
            )
            for i, mechanism in enumerate(self._mechanisms)
        )

    def _prescribe(self, hand: Hand) -> None:
        self._held = None
        for i, mechanism in enumerate(self._mechanisms):
            position = max(-mechanism.travel, min(mechanism.travel, hand.reference[i]))
            self._rate[i] = (position - self._position[i]) / (self._dt * self._ticks)
            self._position[i] = position

    def _tick(self, pull: list[float]) -> None:
        self._age()
        positions, rates = self._position, self._rate
        feedback = self._feedback(positions, rates)
        for i in (0, 1, 2):
            limit, travel, stiffness, damping, gravity, lever, *_ = self._mechanisms[i]
            position, rate = positions[i], rates[i]
            centring = -stiffness * position - damping * rate
            weight = gravity * sin(position / lever) if gravity else 0.0
            if self._as_published:
                force = self._pins(i, feedback[i], centring, -weight)
            else:
                # Signed sum, clipped once; written out, for this is the innermost loop.
                force = feedback[i] + centring - weight
                if force > limit:
                    force = limit
                elif force < -limit:
                    force = -limit
            self._force[i] = force
            qq, qv, qu, vq, vv, vu = self._steps[i]
            push = force + weight + pull[i]
            moved = qq * position + qv * rate + qu * push
            if -travel < moved < travel:
                positions[i] = moved
                rates[i] = vq * position + vv * rate + vu * push
            else:
                positions[i] = travel if moved > 0.0 else -travel
                rates[i] = 0.0

    def _age(self) -> None:
        """Let the ramp go on and the field grow older by one tick."""
        self._since_field += 1
        if self._ramp:
            self._ramp -= 1
            offset, step = self._offset, self._offset_step
            offset[0] += step[0]
            offset[1] += step[1]
            offset[2] += step[2]
        if self._valid:
            self._valid -= 1
            if not self._valid:
                self._go_stale()

    def _feedback(self, position: list[float], rate: list[float]) -> tuple[float, float, float]:
        """Give the field's force at the present position and rate."""
        (kx, ky, kt), (dx, dy, dt) = self._field.stiffness, self._field.damping
        x, y, theta = position
        vx, vy, omega = rate
        fx, fy, tau = self._offset
        if not self._coupled:
            return (
                fx - kx[0] * x - dx[0] * vx,
                fy - ky[1] * y - dy[1] * vy,
                tau - kt[2] * theta - dt[2] * omega,
            )
        return (
            fx - kx[0] * x - kx[1] * y - kx[2] * theta - dx[0] * vx - dx[1] * vy - dx[2] * omega,
            fy - ky[0] * x - ky[1] * y - ky[2] * theta - dy[0] * vx - dy[1] * vy - dy[2] * omega,
            tau - kt[0] * x - kt[1] * y - kt[2] * theta - dt[0] * vx - dt[1] * vy - dt[2] * omega,
        )

    def _pins(self, axis: int, feedback: float, centring: float, gravity: float) -> float:
        scale = self._mechanisms[axis].counts_per_newton
        return (
            motor_counts_as_published(feedback * scale, centring * scale, gravity * scale) / scale
        )

    def _go_stale(self) -> None:
        """Fade to no force over one period of validity (a force is bounded in time, too)."""
        ticks = max(1, round(self._field.valid_for / self._dt))
        self._exchange(NO_FORCE)
        self._offset_step = [-value / ticks for value in self._offset]
        self._ramp = ticks
