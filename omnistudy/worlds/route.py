"""A way through a world: legs that each end at a body to be touched."""

from __future__ import annotations

from math import hypot
from typing import Annotated

from pydantic import Field, field_validator

from omnistudy.registry import Model
from omnistudy.units import Metres

Point = tuple[Metres, Metres]


class Leg(Model):
    """From where the robot is to one body: its name and the corners of the way, in m."""

    target: str
    """Name of the body (role target or finish) to touch at the end."""
    path: Annotated[tuple[Point, ...], Field(min_length=2)]

    @field_validator("path")
    @classmethod
    def _leads_somewhere(cls, path: tuple[Point, ...]) -> tuple[Point, ...]:
        if all(point == path[0] for point in path):
            raise ValueError("a way needs two different points")
        return path

    @property
    def length(self) -> float:
        """Length of the way in m."""
        return sum(
            hypot(bx - ax, by - ay)
            for (ax, ay), (bx, by) in zip(self.path, self.path[1:], strict=False)
        )


class Route(Model):
    """Legs in the order in which they are to be driven; the last ends at the finish."""

    name: str
    legs: Annotated[tuple[Leg, ...], Field(min_length=1)]

    @property
    def length(self) -> float:
        """Length of all legs in m."""
        return sum(leg.length for leg in self.legs)
