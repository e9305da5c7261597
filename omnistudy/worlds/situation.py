"""What a person at the stick is told and shown of the task at one instant."""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot
from typing import NamedTuple

from omnistudy.scene import Body, Box
from omnistudy.worlds.route import Leg


class Passing(NamedTuple):
    """A moving body as it is seen: middle in m, velocity in m/s, radius in m of all of it."""

    x: float
    y: float
    vx: float
    vy: float
    radius: float


class Situation(NamedTuple):
    """The leg being driven (None: nothing to drive to) and whether "drive away" is on screen.

    passing : the moving bodies of the world, where they are now.
    """

    leg: Leg | None = None
    drive_away: bool = False
    passing: tuple[Passing, ...] = ()


def passing(bodies: Iterable[Body], t: float) -> tuple[Passing, ...]:
    """Give those bodies that move as they are t seconds after the trial opened."""
    return tuple(
        Passing(*body.track.at(t), _radius(body)) for body in bodies if body.track is not None
    )


def _radius(body: Body) -> float:
    shape = body.geometry
    return 0.5 * hypot(shape.x, shape.y) if isinstance(shape, Box) else shape.radius
