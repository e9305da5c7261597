"""What mecanum bases share: their size, their wheels' kinematics, what contact means."""

from __future__ import annotations

from math import hypot
from typing import Annotated

from pydantic import Field

from omnistudy.geometry import PlanarTwist
from omnistudy.plants.plant import Plant
from omnistudy.units import Kilograms, Metres, NewtonMetres, Newtons, Positive

WheelSpeeds = tuple[float, float, float, float]
"""Front left, front right, rear left, rear right, rad/s."""


class MecanumBase(Plant):
    """A box on four mecanum wheels; a subclass gives numbers, drive and sensors."""

    half_length: Annotated[Metres, Positive]
    half_width: Annotated[Metres, Positive]
    wheel_radius: Annotated[Metres, Positive]
    wheel_lever: Annotated[Metres, Positive]
    """Half wheelbase plus half track in the Jacobian."""
    mass: Annotated[Kilograms, Positive]
    drive_force: Annotated[Newtons, Positive]
    """What the drive can push with; a wall stops it."""
    drive_torque: Annotated[NewtonMetres, Positive]
    contact_tolerance: Annotated[Metres, Field(ge=0)] = 1e-4
    """A gap up to this counts as touching, so that resting contact does not flicker."""
    release_gap: Annotated[Metres, Positive] = 0.005
    """A touched wall is left once it is further off than this (ours)."""

    @property
    def width(self) -> float:
        """Full width across its way, m."""
        return 2.0 * self.half_width

    @property
    def circumradius(self) -> float:
        """Radius in m of the circle swept when it turns on the spot."""
        return hypot(self.half_length, self.half_width)

    def wheel_speeds(self, twist: PlanarTwist) -> WheelSpeeds:
        """Give the wheel speeds that a twist needs (inverse Jacobian, Tyagi 2017, eq. 2.2)."""
        vx, vy, turn = twist.vx, twist.vy, self.wheel_lever * twist.omega
        radius = self.wheel_radius
        return (
            (vx - vy - turn) / radius,
            (vx + vy + turn) / radius,
            (vx + vy - turn) / radius,
            (vx - vy + turn) / radius,
        )

    def twist(self, wheels: WheelSpeeds) -> PlanarTwist:
        """Give the twist that wheel speeds make (the least-squares inverse of the above)."""
        fl, fr, rl, rr = wheels
        quarter = 0.25 * self.wheel_radius
        return PlanarTwist(
            (fl + fr + rl + rr) * quarter,
            (-fl + fr + rl - rr) * quarter,
            (-fl + fr - rl + rr) * quarter / self.wheel_lever,
        )
