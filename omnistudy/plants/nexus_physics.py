"""The first robot in PyBullet: its wheels follow their commands as their servos let them."""

from __future__ import annotations

from typing import Any

from omnistudy.geometry import PlanarPose, Scan
from omnistudy.plants.chassis_rays import Chassis
from omnistudy.plants.infrared_on_chassis import InfraredOnChassis
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.lidar_on_chassis import LidarOnChassis
from omnistudy.plants.mecanum import WheelSpeeds
from omnistudy.plants.mecanum_physics import RunningMecanum
from omnistudy.plants.nexus import Nexus
from omnistudy.plants.sensor_on_chassis import SensorOnChassis
from omnistudy.scene import Scene


class RunningNexus(RunningMecanum):
    """A mecanum base with wheel servos and the sensors of its choice."""

    def __init__(
        self, nexus: Nexus, scene: Scene, start: PlanarPose, physics_hz: int, seed: str
    ) -> None:
        super().__init__(nexus, scene, start, physics_hz)
        self._nexus = nexus
        self._servo = nexus.servo.start(physics_hz)
        self._sensor = _mounted(nexus, self.chassis, physics_hz, seed)
        self.channels = (*self.channels, *self._sensor.channels)
        self._wanted: WheelSpeeds = (0.0, 0.0, 0.0, 0.0)
        self._turning = self._wanted
        self._steps = 0

    def values(self) -> tuple[float, ...]:
        """Give what the base records, then what the sensors do."""
        return (*super().values(), *self._sensor.values())

    def command(self, command: Any) -> None:
        """Take a PlanarTwist; the inverse Jacobian says what each wheel's servo is told."""
        self._wanted = self._nexus.wheel_speeds(command)

    def step(self) -> None:
        """Let the servos turn the wheels and the wheels drive the base."""
        self._turning = self._servo.advance(self._wanted)
        self.drive(self._turning)
        self._steps += 1
        super().step()

    def scan(self) -> Scan:
        """Give what the sensors tell from the present pose."""
        return self._sensor.scan(self._steps, self._nexus.twist(self._turning))


def _mounted(nexus: Nexus, chassis: Chassis, physics_hz: int, seed: str) -> SensorOnChassis:
    if isinstance(nexus.sensors, InfraredRing):
        return InfraredOnChassis(nexus.sensors, chassis, physics_hz, seed)
    return LidarOnChassis(nexus.sensors, chassis)
