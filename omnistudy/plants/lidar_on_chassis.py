"""The lidar at a robot's centre in PyBullet: exact, and without a memory."""

from __future__ import annotations

import numpy as np

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.plants.chassis_rays import Chassis, ChassisRays
from omnistudy.plants.lidar import Lidar
from omnistudy.plants.sensor_on_chassis import SensorOnChassis


class LidarOnChassis(SensorOnChassis):
    """Rays from the robot's centre."""

    def __init__(self, lidar: Lidar, chassis: Chassis) -> None:
        self._angles = lidar.angles
        self._far = lidar.max_range
        self._rays = ChassisRays(
            [(0.0, 0.0, angle) for angle in self._angles], self._far, lidar.height, chassis
        )

    def scan(self, step: int, twist: PlanarTwist) -> Scan:
        """Give what each ray meets; neither time nor motion matters."""
        return self.look()

    def look(self) -> Scan:
        """Give what each ray meets now."""
        return Scan(self._angles, np.array(self._rays.ranges()), self._far)
