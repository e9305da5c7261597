"""The thesis's first robot: a Nexus mecanum kit with infrared sensors."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from omnistudy.geometry import PlanarPose
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.lidar import Lidar
from omnistudy.plants.mecanum import MecanumBase
from omnistudy.plants.plant import RunningPlant
from omnistudy.plants.wheel_servo import WheelServo
from omnistudy.scene import Scene, Sight
from omnistudy.units import Kilograms, Metres, NewtonMetres, Newtons, Positive


class LidarAtCentre(Lidar):
    """The lidar with which the thesis replaces the infrared sensors (Tyagi 2017, sec. 2.4)."""

    kind: Literal["lidar"] = "lidar"


class Nexus(MecanumBase):
    """Mecanum base whose wheels lag their command (Tyagi 2017, sec. 2.3; the numbers are ours)."""

    kind: Literal["nexus"] = "nexus"
    half_length: Annotated[Metres, Positive] = 0.20
    half_width: Annotated[Metres, Positive] = 0.18
    wheel_radius: Annotated[Metres, Positive] = 0.05
    wheel_lever: Annotated[Metres, Positive] = 0.30
    """Half wheelbase plus half track in the Jacobian; both are 0.30 m in the maker's library."""
    mass: Annotated[Kilograms, Positive] = 12.0
    drive_force: Annotated[Newtons, Positive] = 80.0
    """Four motors at the torque limit of their servo; a wall stops the base and its wheels slip."""
    drive_torque: Annotated[NewtonMetres, Positive] = 24.0
    """The same four about the robot's centre."""
    servo: WheelServo = WheelServo()
    sensors: Annotated[InfraredRing | LidarAtCentre, Field(discriminator="kind")] = InfraredRing()
    """The six infrared sensors, or a lidar at the robot's centre."""

    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        """Put the robot into the scene; its sensors' noise is drawn. Raises StartsInWall."""
        from omnistudy.plants.nexus_physics import RunningNexus

        return RunningNexus(self, scene, start, physics_hz, seed)

    @property
    def sight(self) -> Sight:
        """The rays of its range sensors."""
        return self.sensors.sight
