"""Between SI at the handle and the firmware's counts and PWM steps."""

from __future__ import annotations

from collections.abc import Iterable
from math import copysign
from typing import NamedTuple

import numpy as np

from omnistudy.devices.device import DeviceState
from omnistudy.devices.simulated_stick import DEGREES_PER_COUNT, SimulatedStick
from omnistudy.devices.stick.force_calibration import ForceCalibration
from omnistudy.devices.stick.layouts import DEFAULT_CONFIGURATION, LIMITS, SCALES
from omnistudy.devices.stick.messages import Configuration, Field, Nine, Telemetry, Three
from omnistudy.devices.stick_scale import FULL_DUTY
from omnistudy.geometry import ForceField

MARGIN = 1.2
"""Beyond the mechanical stop by so much, counts can only be wrong (ours)."""
TWIST_TRIP = 15.0
"""Counts/ms of theta, 65 rad/s, that are a fault: the published torque of 4.4 N·m turned handle and
virtual hand at up to 11.5 in ten trials with full feedback (docs/stick.md), and the firmware's own
10 is for a person's wrist (ours)."""


class HandleScale(NamedTuple):
    """What a count and a PWM step are at the handle.

    per_count : m, m, rad.
    per_duty : N, N, N·m; nominal, from the published force at full duty, unless calibrated.
    dead_band : PWM steps that no force comes of; nominally none. It is taken off what the motors
        are said to push, and not added to what they are told: near the centre that would buzz.
    """

    per_count: tuple[float, float, float]
    per_duty: tuple[float, float, float]
    dead_band: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def wire(self, field: ForceField) -> Field:
        """Give the field in wire steps, each number cut to what a frame can carry."""
        count, duty = np.array(self.per_count), np.array(self.per_duty)
        return Field(
            _three("wrench", np.array(field.wrench) / duty),
            _three("about", np.array(field.about) / count),
            _nine("stiffness", np.array(field.stiffness) * count / duty[:, None]),
            _nine("damping", np.array(field.damping) * count / duty[:, None] * 1e3),
            _steps("valid_for", (field.valid_for * 1e3,))[0],
        )

    def state(self, told: Telemetry) -> DeviceState:
        """Give where the stick is, rates to whole counts a second."""
        scale = SCALES[Telemetry]["rate"]
        return DeviceState(
            tuple(c * size for c, size in zip(told.position, self.per_count, strict=True)),
            tuple(
                round(rate / scale * 1e3) * size
                for rate, size in zip(told.rate, self.per_count, strict=True)
            ),
        )

    def force(self, told: Telemetry) -> tuple[float, ...]:
        """Give the commanded motor forces after all limits, N and N·m."""
        return tuple(
            copysign(max(0.0, abs(duty) - band), duty) * size
            for duty, size, band in zip(told.motor, self.per_duty, self.dead_band, strict=True)
        )


def _steps(name: str, values: Iterable[float]) -> tuple[int, ...]:
    low, high = LIMITS[Field][name]
    scale = SCALES[Field].get(name, 1)
    return tuple(max(low, min(high, round(float(value) * scale))) for value in values)


def _three(name: str, values: Iterable[float]) -> Three:
    x, y, theta = _steps(name, values)
    return (x, y, theta)


def _nine(name: str, matrix: np.ndarray) -> Nine:
    a, b, c, d, e, f, g, h, i = _steps(name, matrix.ravel())
    return (a, b, c, d, e, f, g, h, i)


def handle_scale(stick: SimulatedStick, calibration: ForceCalibration | None = None) -> HandleScale:
    """Give the scale of a stick described as the simulated one is.

    calibration : what its forces were found to be; None is nominal.
    """
    count, turn = stick.scale.metres_per_count, stick.scale.radians_per_count
    if calibration is not None:
        x, y, theta = calibration.axes
        return HandleScale(
            (count, count, turn),
            (x.per_duty, y.per_duty, theta.per_duty),
            (x.dead_band, y.dead_band, theta.dead_band),
        )
    force, torque = stick.force_limit / FULL_DUTY, stick.torque_limit / FULL_DUTY
    return HandleScale((count, count, turn), (force, force, torque))


def configuration(stick: SimulatedStick) -> Configuration:
    """Give the firmware's settings for a stick described as the simulated one is."""
    axes = (stick.x, stick.y, stick.theta)
    scale = SCALES[Configuration]
    per_degree = stick.scale.counts_per_degree_x, stick.scale.counts_per_degree_theta

    def three(values: Iterable[float]) -> Three:
        x, y, theta = (round(value) for value in values)
        return (x, y, theta)

    stiffness = scale["centring_stiffness"] * DEGREES_PER_COUNT
    damping = scale["centring_damping"] * DEGREES_PER_COUNT * 1e3
    twist_trip = round(TWIST_TRIP * scale["velocity_trip"])
    return DEFAULT_CONFIGURATION._replace(
        counts_per_degree=three(
            scale["counts_per_degree"] * n for n in (per_degree[0], per_degree[0], per_degree[1])
        ),
        centring_stiffness=three(stiffness * axis.proportional for axis in axes),
        centring_damping=three(damping * axis.derivative for axis in axes),
        gravity=three(axis.gravity for axis in axes),
        travel=three(MARGIN * axis.travel for axis in axes),
        velocity_trip=(*DEFAULT_CONFIGURATION.velocity_trip[:2], twist_trip),
    )
