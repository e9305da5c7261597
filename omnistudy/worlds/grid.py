"""The solid cells of a map, as rectangles of whole cells."""

from __future__ import annotations

from math import cos, sin
from typing import Annotated

from pydantic import Field

from omnistudy.registry import Model
from omnistudy.scene import Body, Box, Colour
from omnistudy.units import Metres, Positive, Radians

Count = Annotated[int, Field(ge=1)]
Index = Annotated[int, Field(ge=0)]
Block = tuple[Index, Index, Count, Count]
"""First column, first row, columns, rows; row 0 is the lowest."""


class Grid(Model):
    """Solid cells on a square grid; (x, y) is the outer corner of cell (0, 0)."""

    name: str = "map"
    """What a robot that touches any of the cells has touched."""
    resolution: Annotated[Metres, Positive]
    """Side of a cell."""
    x: Metres = 0.0
    y: Metres = 0.0
    theta: Radians = 0.0
    """How far the grid is turned about its corner, counter-clockwise."""
    height: Annotated[Metres, Positive] = 0.8
    """As walls have (ours: a map does not say)."""
    colour: Colour = "#8a8f98"
    blocks: tuple[Block, ...] = ()

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The blocks as boxes that stand on the floor."""
        return tuple(self._body(number, block) for number, block in enumerate(self.blocks, start=1))

    def _body(self, number: int, block: Block) -> Body:
        column, row, columns, rows = block
        along, up = (column + columns / 2) * self.resolution, (row + rows / 2) * self.resolution
        c, s = cos(self.theta), sin(self.theta)
        return Body(
            name=f"{self.name}_{number}",
            part_of=self.name,
            role="wall",
            geometry=Box(x=columns * self.resolution, y=rows * self.resolution, z=self.height),
            x=self.x + c * along - s * up,
            y=self.y + s * along + c * up,
            z=self.height / 2,
            yaw=self.theta,
            colour=self.colour,
        )
