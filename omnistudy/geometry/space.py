"""Pose, twist and wrench in space, for arms and other plants that leave the floor."""

from typing import NamedTuple


class Pose(NamedTuple):
    """Position in m and orientation as a unit quaternion (x, y, z, w)."""

    position: tuple[float, float, float]
    quaternion: tuple[float, float, float, float]


class Twist(NamedTuple):
    """Linear velocity in m/s and angular velocity in rad/s."""

    linear: tuple[float, float, float]
    angular: tuple[float, float, float]


class Wrench(NamedTuple):
    """Force in N and torque in N·m."""

    force: tuple[float, float, float]
    torque: tuple[float, float, float]
