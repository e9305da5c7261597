"""Straight walls of one height and thickness, written as lines on the floor."""

from __future__ import annotations

from math import atan2, hypot
from typing import Annotated

from pydantic import field_validator

from omnistudy.registry import Model
from omnistudy.scene import Body, Box, Colour
from omnistudy.units import Metres, Positive
from omnistudy.worlds.route import Point


class Wall(Model):
    """A wall from one end of its centre line to the other."""

    name: str
    ends: tuple[Point, Point]

    @field_validator("ends")
    @classmethod
    def _has_length(cls, ends: tuple[Point, Point]) -> tuple[Point, Point]:
        if ends[0] == ends[1]:
            raise ValueError("a wall needs two different ends")
        return ends

    @property
    def length(self) -> float:
        """Length of the centre line in m."""
        (ax, ay), (bx, by) = self.ends
        return hypot(bx - ax, by - ay)


class Walls(Model):
    """All walls of one make."""

    height: Annotated[Metres, Positive] = 0.8
    """Tyagi 2017, appendix B (V-REP's "80cm high wall")."""
    thickness: Annotated[Metres, Positive] = 0.05
    """Ours: leaves 0.95 m between walls whose centre lines are 1 m apart."""
    colour: Colour = "#8a8f98"
    lines: tuple[Wall, ...] = ()

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The walls as boxes that stand on the floor."""
        return tuple(self._body(wall) for wall in self.lines)

    def _body(self, wall: Wall) -> Body:
        (ax, ay), (bx, by) = wall.ends
        return Body(
            name=wall.name,
            role="wall",
            geometry=Box(x=wall.length, y=self.thickness, z=self.height),
            x=(ax + bx) / 2,
            y=(ay + by) / 2,
            z=self.height / 2,
            yaw=atan2(by - ay, bx - ax),
            colour=self.colour,
        )
