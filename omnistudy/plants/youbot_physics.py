"""The youBot's base in PyBullet: its wheels turn at once as they are told."""

from __future__ import annotations

from typing import Any

from omnistudy.geometry import PlanarPose, Scan
from omnistudy.plants.lidar_on_chassis import LidarOnChassis
from omnistudy.plants.mecanum_physics import RunningMecanum
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Scene


class RunningYoubot(RunningMecanum):
    """A mecanum base with a perfect speed loop and a lidar."""

    def __init__(self, youbot: Youbot, scene: Scene, start: PlanarPose, physics_hz: int) -> None:
        super().__init__(youbot, scene, start, physics_hz)
        self._youbot = youbot
        self._lidar = LidarOnChassis(youbot.lidar, self.chassis)

    def command(self, command: Any) -> None:
        """Take a PlanarTwist; the wheels turn as the inverse Jacobian says."""
        self.drive(self._youbot.wheel_speeds(command))

    def scan(self) -> Scan:
        """Give a turn of the lidar from the present pose."""
        return self._lidar.look()
