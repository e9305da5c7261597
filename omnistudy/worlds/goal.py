"""Where an imported world is to be driven to, and the way there."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from omnistudy.errors.worlds import NoWay
from omnistudy.geometry import PlanarPose
from omnistudy.scene import Body, Box
from omnistudy.worlds.route import Leg, Point, Route

GOAL = Box(x=0.15, y=0.15, z=0.1)


def goal_block(goal: Point) -> Body:
    """Give a finish block that stops nothing."""
    return Body(
        name="goal",
        role="finish",
        geometry=GOAL,
        x=goal[0],
        y=goal[1],
        z=GOAL.z / 2,
        colour="#2f6fd0",
        solid=False,
    )


def way_to(start: PlanarPose, path: Sequence[Point], goal: Point) -> Route:
    """Join start, path and goal, points that repeat left out; raises NoWay."""
    points = [(start.x, start.y), *path, goal]
    way = [point for i, point in enumerate(points) if i == 0 or point != points[i - 1]]
    if len(way) < 2 or not all(isfinite(number) for number in (*start, *goal)):
        raise NoWay(start, goal)
    return Route(name="reference", legs=(Leg(target="goal", path=tuple(way)),))
