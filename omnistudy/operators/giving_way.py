"""When a driver lets a moving body pass: going on would meet it, and standing would not."""

from __future__ import annotations

from math import hypot, inf

from omnistudy.geometry import PlanarPose
from omnistudy.operators.way import Way
from omnistudy.worlds.situation import Passing

GLANCE = 0.1
"""s between the moments ahead that are thought through (ours)."""

HALF_ROBOT = 0.35
"""Radius in m that the driver keeps free round the robot's middle (ours): half its diagonal."""


def waits(
    bodies: tuple[Passing, ...],
    way: Way,
    pose: PlanarPose,
    speed: float,
    foresight: float,
    berth: float,
) -> bool:
    """Tell whether a driver who would go along the way at `speed` m/s rather stands.

    Bodies are taken to go on as they go. The driver stands if the robot would come nearer than
    `berth` m to one of them within `foresight` s, and would not if it stood; where both would
    end so, the driver goes on, out of the way.
    """
    if not bodies:
        return False
    moments = [GLANCE * n for n in range(round(foresight / GLANCE) + 1)]
    going = [way.at(way.place + speed * t) for t in moments]
    standing = [(pose.x, pose.y)] * len(moments)
    return _nearest(bodies, moments, going) < berth <= _nearest(bodies, moments, standing)


def _nearest(
    bodies: tuple[Passing, ...], moments: list[float], places: list[tuple[float, float]]
) -> float:
    """Give the least gap in m between robot and bodies if the robot is at places[i] then."""
    least = inf
    for t, (x, y) in zip(moments, places, strict=True):
        for body in bodies:
            away = hypot(body.x + body.vx * t - x, body.y + body.vy * t - y)
            least = min(least, away - body.radius - HALF_ROBOT)
    return least
