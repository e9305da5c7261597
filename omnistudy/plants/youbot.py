"""The youBot-size mecanum base of the thesis."""

from __future__ import annotations

from math import hypot
from typing import Annotated, Literal

from pydantic import Field

from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.plants.lidar import Lidar
from omnistudy.plants.plant import Plant, RunningPlant
from omnistudy.scene import Scene
from omnistudy.units import Kilograms, Metres, NewtonMetres, Newtons, Positive

WheelSpeeds = tuple[float, float, float, float]
"""Front left, front right, rear left, rear right, rad/s."""


class Youbot(Plant):
    """Mecanum base with a perfect speed loop (Tyagi 2017, sec. 2.4)."""

    kind: Literal["youbot"] = "youbot"
    half_length: Annotated[Metres, Positive] = 0.29
    half_width: Annotated[Metres, Positive] = 0.19
    wheel_radius: Annotated[Metres, Positive] = 0.05
    wheel_lever: Annotated[Metres, Positive] = 0.29
    """Half wheelbase plus half track in the Jacobian; the thesis's code has the half length."""
    mass: Annotated[Kilograms, Positive] = 24.0
    drive_force: Annotated[Newtons, Positive] = 200.0
    """What the drive can push with; a wall stops it."""
    drive_torque: Annotated[NewtonMetres, Positive] = 50.0
    contact_tolerance: Annotated[Metres, Field(ge=0)] = 1e-4
    """A gap up to this counts as touching, so that resting contact does not flicker."""
    release_gap: Annotated[Metres, Positive] = 0.005
    """A touched wall is left once it is further off than this (ours)."""
    lidar: Lidar = Lidar()

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

    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        """Put the base into the scene; it draws nothing. Raises StartsInWall."""
        from omnistudy.plants.youbot_physics import RunningYoubot

        return RunningYoubot(self, scene, start, physics_hz)
