"""An arm on a wheelchair as data: its joints, its chair, its limits, its zones."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from omnistudy.arm.zones import LAB_ZONES, Zone
from omnistudy.registry import Model
from omnistudy.units import Metres, MetresPerSecond, Positive, Radians, RadiansPerSecond

Floats = NDArray[np.float64]
JointAngles = Annotated[tuple[Radians, ...], Field(min_length=1)]


class Joint(Model):
    """One revolute joint in Craig's modified notation: T = Rx(alpha) Tx(a) Rz(q) Tz(d)."""

    alpha: Radians
    """Twist about the x axis of the frame before."""
    a: Metres = 0.0
    """Length along the same x axis."""
    d: Metres
    """Offset along the joint's own axis."""
    lower: Radians
    upper: Radians
    top_speed: Annotated[RadiansPerSecond, Positive] = 0.5
    """Either way (Farelo 2009, appendix B, WMRA_Opt, p. 130)."""

    @model_validator(mode="after")
    def _has_a_range(self) -> Self:
        if self.lower >= self.upper:
            raise ValueError(f"lower {self.lower:g} rad is not below upper {self.upper:g} rad")
        return self


class Chair(Model):
    """A wheelchair on two driven wheels; the arm's base stands off the middle of the axle."""

    track: Annotated[Metres, Positive]
    """From wheel to wheel (l1)."""
    arm_x: Metres
    """Arm's base ahead of the axle (l2)."""
    arm_y: Metres
    """Arm's base to the left of the axle's middle (l3)."""
    arm_z: Metres
    """Arm's base above the axle (l4)."""
    wheel_radius: Annotated[Metres, Positive]
    """Of a driven wheel (l5)."""
    top_speed: Annotated[MetresPerSecond, Positive] = 0.1
    """Either way (Farelo 2009, WMRA_Opt, p. 130)."""
    top_turn: Annotated[RadiansPerSecond, Positive] = 0.15
    """Either way (Farelo 2009, WMRA_Opt, p. 130)."""

    @property
    def arm_height(self) -> float:
        """Height of the arm's base above the floor, m."""
        return self.arm_z + self.wheel_radius


class ArmProfile(Model):
    """One arm on one wheelchair; lengths in m, angles in rad."""

    name: str
    title: str
    joints: Annotated[tuple[Joint, ...], Field(min_length=6)]
    gripper: Annotated[Metres, Field(ge=0)] = 0.0
    """What the hand adds to the last joint's `d`, up to the point that is controlled."""
    chair: Chair
    ready: JointAngles
    park: JointAngles
    zones: tuple[Zone, ...] = LAB_ZONES
    """Where points of the arm must not be."""

    @model_validator(mode="after")
    def _postures_fit(self) -> Self:
        for name, posture in (("ready", self.ready), ("park", self.park)):
            if len(posture) != len(self.joints):
                raise ValueError(
                    f"{name} has {len(posture)} angles, but there are {len(self.joints)} joints"
                )
        for zone in self.zones:
            if max(zone.joint, zone.seen_from_joint) > len(self.joints):
                raise ValueError(f"zone '{zone.name}' names a joint that the arm does not have")
        return self

    @cached_property
    def lower(self) -> Floats:
        """Lower limits of the joints, rad, (n,)."""
        return np.array([joint.lower for joint in self.joints])

    @cached_property
    def upper(self) -> Floats:
        """Upper limits of the joints, rad, (n,)."""
        return np.array([joint.upper for joint in self.joints])

    @cached_property
    def top_rates(self) -> Floats:
        """Greatest rates either way: joints in rad/s, then drive in m/s, then turn in rad/s."""
        speeds = [joint.top_speed for joint in self.joints]
        return np.array([*speeds, self.chair.top_speed, self.chair.top_turn])
