"""Pose, twist and wrench on the floor. Robot frame: x forward, y left, theta counter-clockwise."""

from __future__ import annotations

from math import cos, pi, sin
from typing import NamedTuple


class PlanarPose(NamedTuple):
    """Position and heading in the world: x, y in m, theta in rad."""

    x: float
    y: float
    theta: float

    def to_world(self, x: float, y: float) -> tuple[float, float]:
        """Express a point of this pose's frame, in m, in world coordinates."""
        c, s = cos(self.theta), sin(self.theta)
        return self.x + c * x - s * y, self.y + s * x + c * y

    def to_local(self, x: float, y: float) -> tuple[float, float]:
        """Express a world point, in m, in this pose's frame."""
        c, s = cos(self.theta), sin(self.theta)
        dx, dy = x - self.x, y - self.y
        return c * dx + s * dy, c * dy - s * dx


class PlanarTwist(NamedTuple):
    """Velocity in the robot's own frame: vx, vy in m/s, omega in rad/s."""

    vx: float
    vy: float
    omega: float


class PlanarWrench(NamedTuple):
    """Force and torque felt by the hand at the joystick: fx, fy in N, tau in N·m."""

    fx: float
    fy: float
    tau: float


def wrapped(angle: float) -> float:
    """Bring an angle in rad into [-pi, pi)."""
    return (angle + pi) % (2.0 * pi) - pi
