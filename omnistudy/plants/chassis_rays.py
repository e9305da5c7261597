"""Range rays that ride on a chassis in PyBullet."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin
from typing import NamedTuple

from omnistudy.plants.bullet import pybullet

Ray = tuple[float, float, float]
"""Where a ray starts in the robot's frame (x, y in m) and its direction in rad."""


class Chassis(NamedTuple):
    """The PyBullet client, body and link that carry sensors, and the link's height in m."""

    client: int
    body: int
    link: int
    height: float


class ChassisRays:
    """Rays of one length at one height, cast again and again from wherever the chassis is."""

    def __init__(self, rays: Sequence[Ray], length: float, height: float, chassis: Chassis) -> None:
        """Prepare the rays; length and height above the floor in m."""
        self._length = length
        self._chassis = chassis
        z = height - chassis.height
        self._from = [[x, y, z] for x, y, _ in rays]
        self._to = [[x + length * cos(a), y + length * sin(a), z] for x, y, a in rays]

    def ranges(self) -> list[float]:
        """Give how far each ray gets, in m; its length where it meets nothing."""
        hits = pybullet.rayTestBatch(
            self._from,
            self._to,
            parentObjectUniqueId=self._chassis.body,
            parentLinkIndex=self._chassis.link,
            physicsClientId=self._chassis.client,
        )
        return [hit[2] * self._length for hit in hits]
