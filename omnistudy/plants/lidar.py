"""A ring of range rays on a robot."""

from __future__ import annotations

from math import pi
from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from omnistudy.registry import Model
from omnistudy.scene import Sight
from omnistudy.units import Metres, Positive, Radians


class Lidar(Model):
    """Rays at equal steps round the robot's centre (Tyagi 2017, sec. 2.4)."""

    rays: Annotated[int, Field(ge=4, le=2048)] = 128
    """128 rays are 2.8125 degrees apart."""
    first: Radians = -pi
    max_range: Annotated[Metres, Positive] = 0.6
    """The thesis's 0.5 m cuts off its own field's corners (0.538 m), as laws `as_published` do."""
    height: Annotated[Metres, Positive] = 0.3
    """Above the floor; low blocks are not seen."""

    @property
    def angles(self) -> NDArray[np.float64]:
        """(rays,) rad, robot frame, counter-clockwise."""
        return self.first + np.arange(self.rays, dtype=np.float64) * (2.0 * pi / self.rays)

    @property
    def sight(self) -> Sight:
        """Its rays, which all start at the robot's centre."""
        return Sight(
            origins=((0.0, 0.0),) * self.rays,
            angles=tuple(self.angles.tolist()),
            height=self.height,
            max_range=self.max_range,
        )
