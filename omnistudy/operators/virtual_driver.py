"""A virtual person: preview, delay, noise, lapses, and an arm that yields to the stick."""

from __future__ import annotations

from math import exp, sqrt
from statistics import NormalDist
from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from omnistudy.operators.operator import Operator, Person, RunningOperator
from omnistudy.registry import Model
from omnistudy.seeds import generator
from omnistudy.units import (
    Hertz,
    Kilograms,
    Metres,
    NewtonMetreSeconds,
    NewtonMetresPerRadian,
    NewtonsPerMetre,
    Positive,
    Radians,
    Ratio,
    Seconds,
)

NonNegative = Field(ge=0)


class Perception(Model):
    """What the driver sees and how badly (docs/virtual-driver.md)."""

    rate: Annotated[Hertz, Positive] = 20.0
    preview: Annotated[Metres, Positive] = 0.7
    """How far along the way the driver aims."""
    near_point: Annotated[Metres, NonNegative] = 0.3
    """Where ahead of the robot its place between the walls is judged."""
    half_view: Annotated[Radians, Positive] = 1.0472
    """60 degrees either way; what is further aside is turned to on the spot."""
    lateral_noise: Annotated[Metres, NonNegative] = 0.10
    """Standard deviation at skill 1."""
    bearing_noise: Annotated[Radians, NonNegative] = 0.10
    """Standard deviation at skill 1."""
    noise_memory: Annotated[Seconds, Positive] = 1.5


class Decision(Model):
    """From what is seen to what is wanted (docs/virtual-driver.md)."""

    lateral_gain: Annotated[Ratio, NonNegative] = 1.2
    """Lateral speed per lateral error, 1/s."""
    bearing_gain: Annotated[Ratio, NonNegative] = 1.6
    """Turning rate per bearing error, 1/s."""
    pace: Annotated[Ratio, Positive] = 0.9
    """Preferred speed as a share of full stick (ours)."""
    delay: Annotated[Seconds, NonNegative] = 0.2
    """From seeing to acting, mean over people."""
    delay_spread: Annotated[Seconds, NonNegative] = 0.03
    lapses: Annotated[Hertz, NonNegative] = 0.06
    """Moments a second, at skill 1, in which the last command is held on."""
    lapse_shortest: Annotated[Seconds, NonNegative] = 0.3
    lapse_mean: Annotated[Seconds, NonNegative] = 0.5
    """Mean of the exponential part of a lapse's length."""
    recovery_pause: Annotated[Seconds, NonNegative] = 0.4
    """From contact to driving away from the wall."""
    recovery_shortest: Annotated[Seconds, Positive] = 0.5
    recovery_longest: Annotated[Seconds, Positive] = 0.9
    recovery_noise: Annotated[Radians, NonNegative] = 0.5
    """Standard deviation of the direction at skill 1."""
    recovery_pace: Annotated[Ratio, Positive] = 0.6
    """Share of full stick while driving away (ours)."""
    patience: Annotated[Seconds, NonNegative] = 1.0
    """How long the robot may stand still against the driver's will before he pushes harder (ours):
    people push a closed door open against the feedback (Tyagi 2017, ch. 4)."""
    insistence: Annotated[Hertz, NonNegative] = 0.5
    """How fast the wanted deflection then grows, shares of itself a second (ours)."""
    greatest_effort: Annotated[Ratio, Field(ge=1)] = 3.0
    """Most that the wanted deflection grows to (ours): about 30 N at the median arm."""
    relaxation: Annotated[Seconds, Positive] = 2.0
    """Time constant with which the effort falls back once the robot moves (ours)."""
    foresight: Annotated[Seconds, NonNegative] = 2.5
    """How far ahead the driver thinks moving bodies on, to let them pass (ours)."""
    berth: Annotated[Metres, NonNegative] = 0.15
    """Gap to a moving body below which the driver rather stands (ours)."""


class Arm(Model):
    """Hand and arm at the handle: a mass, damper and spring an axis (docs/virtual-driver.md)."""

    stiffness_median: Annotated[NewtonsPerMetre, Positive] = 200.0
    """Prior over people: log-normal (docs/virtual-driver.md gives the sources)."""
    stiffness_spread: Annotated[Ratio, NonNegative] = 0.35
    """Standard deviation of the logarithm."""
    mass: Annotated[Kilograms, Positive] = 0.8
    damping_ratio: Annotated[Ratio, Positive] = 0.7
    yaw_stiffness: Annotated[NewtonMetresPerRadian, Positive] = 2.0
    """At the median stiffness; it grows with a person's stiffness."""
    yaw_damping: Annotated[NewtonMetreSeconds, Positive] = 0.1
    yaw_inertia: Annotated[Ratio, Positive] = 0.003
    """kg·m²."""
    motor_noise: Annotated[Ratio, NonNegative] = 0.10
    """Relative standard deviation of the wanted deflection, at skill 1."""
    motor_memory: Annotated[Seconds, Positive] = 0.2


class StickSense(Model):
    """What the driver has learnt of the stick while practising."""

    full_travel: Annotated[Metres, Positive] = 0.04145
    """Handle travel for full speed: 300 counts."""
    full_twist: Annotated[Radians, Positive] = 1.0908
    """Handle twist for full turning: 250 counts."""
    top_speed: Annotated[Ratio, Positive] = 0.36
    """m/s at full stick."""
    top_turning: Annotated[Ratio, Positive] = 1.2
    """rad/s at full stick."""
    dead_zone: Annotated[Ratio, NonNegative] = 0.2222
    """Share of full stick that does nothing, x and y."""
    dead_zone_theta: Annotated[Ratio, NonNegative] = 0.1667
    centring: Annotated[NewtonsPerMetre, NonNegative] = 67.0
    """The stick's own spring, which the arm has learnt to overcome."""
    centring_theta: Annotated[NewtonMetresPerRadian, NonNegative] = 1.315


class VirtualDriver(Operator):
    """The minimal honest driver (docs/virtual-driver.md): feedback reaches it only as force.

    `skill` 0 is perfect. Person n-th trial: skill = first · n^-learning. `skill_median` and
    `skill_spread` are calibrated on no-feedback trials alone (`omnistudy operator calibrate`).
    """

    kind: Literal["virtual_driver"] = "virtual_driver"
    skill_median: Annotated[Ratio, NonNegative] = 2.6
    skill_spread: Annotated[Ratio, NonNegative] = 0.3
    """Standard deviation of the logarithm over people."""
    learning: Annotated[Ratio, NonNegative] = 0.25
    """Exponent of practice."""
    arm_stiffness_quantile: Annotated[Ratio, Field(gt=0, lt=1)] | None = None
    """Where in the prior everybody's arm lies; None draws each person's own."""
    perception: Perception = Perception()
    decision: Decision = Decision()
    arm: Arm = Arm()
    stick: StickSense = StickSense()

    def traits(self, participant_seed: str) -> Traits:
        """Draw what makes one person different from another."""
        rng = generator(participant_seed, "traits")
        skill, delay, arm = (float(value) for value in rng.standard_normal(3))
        if self.arm_stiffness_quantile is not None:
            arm = NormalDist().inv_cdf(self.arm_stiffness_quantile)
        return Traits(
            first_skill=self.skill_median * exp(self.skill_spread * skill),
            delay=max(0.05, self.decision.delay + self.decision.delay_spread * delay),
            arm_stiffness=self.arm.stiffness_median * exp(self.arm.stiffness_spread * arm),
        )

    def impedance(self, traits: Traits) -> Impedance:
        """Give a person's arm as three springs, dampers and masses (x, y, theta)."""
        k = traits.arm_stiffness
        b = 2.0 * self.arm.damping_ratio * sqrt(k * (self.arm.mass + 0.1))
        ratio = k / self.arm.stiffness_median
        return Impedance(
            (k, k, self.arm.yaw_stiffness * ratio),
            (b, b, self.arm.yaw_damping * sqrt(ratio)),
            (self.arm.mass, self.arm.mass, self.arm.yaw_inertia),
        )

    def begin(self, person: Person, physics_hz: int) -> RunningOperator:
        """Give the driver before the first step of a trial."""
        from omnistudy.operators.virtual_driving import VirtualDriving

        return VirtualDriving(self, person)


class Traits(NamedTuple):
    """One person: skill in the first trial, delay in s, arm stiffness in N/m."""

    first_skill: float
    delay: float
    arm_stiffness: float


class Impedance(NamedTuple):
    """Per axis (x, y, theta): N/m, N·s/m, kg; the last in N·m/rad, N·m·s, kg·m²."""

    stiffness: tuple[float, float, float]
    damping: tuple[float, float, float]
    mass: tuple[float, float, float]
