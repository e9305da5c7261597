"""What mecanum bases share: their size, their wheels' kinematics, what contact means."""

from __future__ import annotations

from math import hypot, pi
from typing import Annotated

from pydantic import Field

from omnistudy.geometry import PlanarTwist
from omnistudy.plants.plant import Plant
from omnistudy.scene import Box, Cylinder, Joint, Link
from omnistudy.units import Kilograms, Metres, NewtonMetres, Newtons, Positive

WheelSpeeds = tuple[float, float, float, float]
"""Front left, front right, rear left, rear right, rad/s."""

WHEELS = ("wheel_front_left", "wheel_front_right", "wheel_rear_left", "wheel_rear_right")
"""Names of the wheels and of the channels of their speeds, in the order of WheelSpeeds."""

CHASSIS_HEIGHT = 0.1
CHASSIS_HALF_HEIGHT = 0.05
CHASSIS_COLOUR = "#edb40e"
WHEEL_WIDTH = 0.05
WHEEL_PROUD = 0.002
"""Wheels stand out of the chassis by this, so that it is a wheel that rubs along a wall, in m."""
WHEEL_INSET = 0.07
"""Wheel axles from the chassis's ends, m."""


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

    @property
    def footprint(self) -> tuple[float, float]:
        """Half length and half width, m."""
        return self.half_length, self.half_width

    @property
    def axles(self) -> tuple[tuple[float, float], ...]:
        """Where the wheels' middles are, (x, y) in m in the robot's frame, as WHEELS names them."""
        ahead, aside = self.half_length - WHEEL_INSET, self.half_width - 0.5 * WHEEL_WIDTH
        return tuple((x, y) for x in (ahead, -ahead) for y in (aside, -aside))

    @property
    def links(self) -> tuple[Link, ...]:
        """The chassis, open at the wheels, and the wheels: their rollers lie as an X from above."""
        height, side = 2.0 * CHASSIS_HALF_HEIGHT, self.half_width - WHEEL_PROUD
        between = self.axles[0][0] - self.wheel_radius
        chassis = Box(x=2.0 * self.half_length, y=2.0 * (side - WHEEL_WIDTH), z=height)
        flanks = Box(x=2.0 * between, y=2.0 * side, z=height)
        tyre = Cylinder(radius=self.wheel_radius, length=WHEEL_WIDTH)
        return (
            Link(name="chassis", geometry=chassis, z=CHASSIS_HEIGHT, colour=CHASSIS_COLOUR),
            Link(name="flanks", geometry=flanks, z=CHASSIS_HEIGHT, colour=CHASSIS_COLOUR),
            *(
                Link(
                    name=name,
                    geometry=tyre,
                    x=x,
                    y=y,
                    z=self.wheel_radius,
                    roll=-0.5 * pi,
                    colour="#2b2f36",
                    surface="rollers_left" if x * y > 0.0 else "rollers_right",
                    joint=Joint(channel=name, rate=True),
                )
                for name, (x, y) in zip(WHEELS, self.axles, strict=True)
            ),
        )

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
