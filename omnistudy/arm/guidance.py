"""What leads an arm, as the numbers of a device: the hand's twist, the chair's goal."""

from __future__ import annotations

from math import atan2, hypot, isnan, nan
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.arm import BadGuidance
from omnistudy.geometry import PlanarPose

Floats = NDArray[np.float64]

TWIST, WITH_BEARING, WITH_GOAL = 6, 7, 10
"""How many numbers a device may give."""


class Guidance(NamedTuple):
    """What is asked of the hand and the chair in one step.

    twist : (6,), the hand's velocity in m/s and rad/s; a controller knows in whose axes.
    bearing : direction on the floor into which the whole path leads, rad from the ground's x
        axis; nan when there is no path, as with a person's device.
    chair_goal : where the chair should end; None when nobody cares.
    """

    twist: Floats
    bearing: float = nan
    chair_goal: PlanarPose | None = None

    @property
    def numbers(self) -> tuple[float, ...]:
        """Give the same as positions of a device's axes: 6, 7 or 10 of them."""
        twist = tuple(self.twist.tolist())
        if self.chair_goal is not None:
            return (*twist, self.bearing, *self.chair_goal)
        return twist if isnan(self.bearing) else (*twist, self.bearing)

    @classmethod
    def read(cls, numbers: tuple[float, ...]) -> Guidance:
        """Read a device's position: a twist, and perhaps a bearing, and perhaps a chair's goal.

        Raises BadGuidance.
        """
        if len(numbers) not in (TWIST, WITH_BEARING, WITH_GOAL):
            raise BadGuidance(len(numbers))
        bearing = numbers[TWIST] if len(numbers) > TWIST else nan
        goal = PlanarPose(*numbers[WITH_BEARING:]) if len(numbers) == WITH_GOAL else None
        return cls(np.array(numbers[:TWIST]), bearing, goal)

    def heading_wanted(self) -> float:
        """Give the bearing, else where the twist leads over the floor; nan when it leads nowhere.

        The twist is then taken in ground axes.
        """
        if not isnan(self.bearing):
            return self.bearing
        x, y = self.twist[:2].tolist()
        return atan2(y, x) if hypot(x, y) > 0.0 else nan
