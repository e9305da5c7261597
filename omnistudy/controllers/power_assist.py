"""The hand's force asks for a velocity, and gets less of it near obstacles."""

from __future__ import annotations

from math import copysign, exp, hypot, inf, pi
from typing import Annotated, Any, Literal

import numpy as np
from annotated_types import Ge, Gt, Le

from omnistudy.controllers.controller import Control, Controller
from omnistudy.devices import DeviceState
from omnistudy.devices.simulated_stick import DEGREES_PER_COUNT, SimulatedStick
from omnistudy.devices.stick_scale import FULL_DUTY
from omnistudy.geometry import Matrix3, PlanarTwist, Scan
from omnistudy.registry import Model
from omnistudy.units import (
    Metres,
    MetresPerSecond,
    MetresPerSecondPerNewton,
    NewtonMetresPerRadian,
    NewtonsPerMetre,
    Positive,
    Radians,
    RadiansPerSecondPerNewtonMetre,
    Ratio,
    Seconds,
)

_STICK = SimulatedStick()

GRAZE = 0.02
"""m by which the outline may brush past an obstacle, so that a robot that touches a wall can leave
it and drive along it (ours)."""


class Centring(Model):
    """Springs that hold the stick in its centre."""

    x: Annotated[NewtonsPerMetre, Positive] = (
        _STICK.x.proportional
        * (_STICK.force_limit / FULL_DUTY)
        / (_STICK.scale.metres_per_count / DEGREES_PER_COUNT)
    )
    """The published stick's: 0.7 PWM per motor degree (appendix B), 67 N/m at the handle."""

    y: Annotated[NewtonsPerMetre, Positive] = x
    """As in x."""

    theta: Annotated[NewtonMetresPerRadian, Positive] = (
        _STICK.theta.proportional
        * (_STICK.torque_limit / FULL_DUTY)
        / (_STICK.scale.radians_per_count / DEGREES_PER_COUNT)
    )
    """The published stick's: 1.9·0.7 PWM per motor degree (appendix B), 1.31 N·m/rad."""


class AssistGain(Model):
    """Velocity for a steady force, K of eq. 1.6."""

    x: Annotated[MetresPerSecondPerNewton, Ge(0.0)] = 0.13
    """Ours: the published stick held at its stop, 2.8 N, asks for the published 0.36 m/s."""

    y: Annotated[MetresPerSecondPerNewton, Ge(0.0)] = 0.13
    """As in x."""

    theta: Annotated[RadiansPerSecondPerNewtonMetre, Ge(0.0)] = 0.84
    """Ours: at 250 counts, 1.43 N·m, it asks for the published 1.2 rad/s."""


class AssistLag(Model):
    """Time constants of the first-order lags, T of eq. 1.6."""

    x: Annotated[Seconds, Positive] = 0.15
    """Ours: the source says that it depends on the operator's skill."""

    y: Annotated[Seconds, Positive] = 0.15
    """As in x."""

    theta: Annotated[Seconds, Positive] = 0.15
    """As in x."""


class PowerAssistController(Controller):
    """A force on the handle asks for a velocity, and for less of it near obstacles.

    The power assist of Ueno et al. 2011 after Tyagi 2017, sec. 1.5, eq. 1.6-1.7:
    v = k·K/(T·s + 1)·f for x, y and theta, each for itself. In x and y the gain is multiplied by
    k = 1 - (rmin/r)^((vmax - |v|·alpha)·beta): 0 where the gap r is rmin or less, 1 far off (that
    k multiplies is ours). r is how far the robot's outline may go on the straight way that the
    force asks for, so that what lies behind or beside never holds the robot back.

    A stick has no force sensor: f is its displacement times the stiffness of its centring, which
    is the hand's force while the stick is held still and no law pushes on it.
    """

    kind: Literal["power_assist"] = "power_assist"

    centring: Centring = Centring()
    """What turns the stick's displacement into the hand's force."""

    gain: AssistGain = AssistGain()
    """K of eq. 1.6."""

    lag: AssistLag = AssistLag()
    """T of eq. 1.6."""

    least_gap: Annotated[Metres, Positive] = 0.05
    """rmin, from the robot's outline. Ours."""

    top_speed: Annotated[MetresPerSecond, Positive] = 0.36
    """vmax in x and y: the published robot's (appendix B)."""

    alpha: Annotated[Ratio, Ge(0.0), Le(1.0)] = 0.5
    """How much sooner a fast robot is held back. Ours."""

    beta: Annotated[Ratio, Positive] = 5.0
    """Per m/s: how late a robot is held back. Ours: the exponent is 1.8 at rest and 0.9 at vmax, so
    that the published robot, asked for all its speed, stops 3 cm before a wall."""

    half_length: Annotated[Metres, Gt(GRAZE)] = 0.29
    """Of the robot's outline, front to back (appendix B)."""

    half_width: Annotated[Metres, Gt(GRAZE)] = 0.19
    """Of the robot's outline, side to side (appendix B)."""

    unseen_front: Annotated[Radians, Ge(0.0), Le(pi)] = pi / 4.0
    """Rays that look less than this off straight ahead are not used: their lidars look back and
    aside, and the operator watches the front. The angle is ours; 0 uses every ray."""

    @property
    def twist_per_stick(self) -> Matrix3:
        """3x3 d(intent)/d(stick): gain times centring, (m/s)/m and (rad/s)/rad."""
        gain, centring = self.gain, self.centring
        return (
            (gain.x * centring.x, 0.0, 0.0),
            (0.0, gain.y * centring.y, 0.0),
            (0.0, 0.0, gain.theta * centring.theta),
        )

    def initial_state(self) -> PlanarTwist:
        """Give the robot's velocity before the first step: none."""
        return PlanarTwist(0.0, 0.0, 0.0)

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Let each velocity follow its force for `dt` seconds, the force held meanwhile.

        The intent is what the force asks for, without lag and obstacles; the state is the command.
        """
        (x, _, _), (_, y, _), (_, _, theta) = self.twist_per_stick
        q = device.position
        asked = PlanarTwist(x * q[0], y * q[1], theta * q[2])
        gap = inf if scan is None else self.gap(scan, asked)
        lag = self.lag
        command = PlanarTwist(
            _followed(state.vx, self.share_of_gain(gap, state.vx) * asked.vx, dt / lag.x),
            _followed(state.vy, self.share_of_gain(gap, state.vy) * asked.vy, dt / lag.y),
            _followed(state.omega, asked.omega, dt / lag.theta),
        )
        return Control(asked, command, command)

    def share_of_gain(self, gap: float, speed: float) -> float:
        """Give k of eq. 1.7 for a gap in m and a speed along one axis in m/s, 0 to 1."""
        if gap <= self.least_gap:
            return 0.0
        exponent = (self.top_speed - min(abs(speed), self.top_speed) * self.alpha) * self.beta
        return 1.0 - float((self.least_gap / gap) ** exponent)

    def gap(self, scan: Scan, towards: PlanarTwist) -> float:
        """Give how far in m the outline can go straight on, inf where nothing is in its way."""
        speed = hypot(towards.vx, towards.vy)
        used = (scan.ranges > 0.0) & (scan.ranges < scan.max_range)
        used &= np.abs(np.arctan2(np.sin(scan.angles), np.cos(scan.angles))) >= self.unseen_front
        if speed == 0.0 or not used.any():
            return inf
        x, y = scan.points()[used].T
        vx, vy = towards.vx / speed, towards.vy / speed
        x, y = x * copysign(1.0, vx), y * copysign(1.0, vy)
        length, width = self.half_length - GRAZE, self.half_width - GRAZE
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            # A point is under the outline once it is so in both directions.
            meets = np.maximum((x - length) / abs(vx), (y - width) / abs(vy))
            leaves = np.minimum((x + length) / abs(vx), (y + width) / abs(vy))
        met = meets[(meets < leaves) & (leaves > 0.0)]
        return max(0.0, float(met.min(initial=inf)) - GRAZE)


def _followed(speed: float, target: float, time: float) -> float:
    """Give a first-order lag's output after some time constants of a held input, exactly."""
    return target + (speed - target) * exp(-time)
