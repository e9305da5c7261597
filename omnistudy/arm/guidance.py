"""What leads an arm, as the numbers of a device: the hand's twist, the chair's goal."""

from __future__ import annotations

from math import atan2, hypot, isnan, nan
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.arm import BadGuidance
from omnistudy.geometry import PlanarPose

Floats = NDArray[np.float64]

TWIST, WITH_BEARING, WITH_GOAL, LED = 6, 7, 10, 18
"""How many numbers a device may give; more are the posture's."""

NOWHERE, UNLED = PlanarPose(nan, nan, nan), (nan, nan)
"""Numbers that stand for no goal and no rates of the chair."""


class Guidance(NamedTuple):
    """What is asked of the hand and the chair in one step.

    twist : (6,), the hand's velocity in m/s and rad/s; a controller knows in whose axes.
    bearing : direction on the floor into which the whole path leads, rad from the ground's x
        axis; nan when there is no path, as with a person's device.
    chair_goal : where the chair should end; None when nobody cares.
    chair_rates : drive in m/s and turn in rad/s of the chair at the same time; None leaves the
        chair to the controller.
    correction : (6,) what of the twist only brings the hand back to its way.
    posture : (n,) rates of the joints, rad/s, that suit best where there is a choice, or None.
    """

    twist: Floats
    bearing: float = nan
    chair_goal: PlanarPose | None = None
    chair_rates: tuple[float, float] | None = None
    correction: Floats | None = None
    posture: Floats | None = None

    @property
    def numbers(self) -> tuple[float, ...]:
        """Give the same as positions of a device's axes: 6, 7, 10, or 18 and the posture's."""
        twist = tuple(self.twist.tolist())
        if self.correction is not None:
            posture = () if self.posture is None else self.posture.tolist()
            goal, rates = self.chair_goal or NOWHERE, self.chair_rates or UNLED
            return (*twist, self.bearing, *goal, *rates, *self.correction.tolist(), *posture)
        if self.chair_goal is not None:
            return (*twist, self.bearing, *self.chair_goal)
        return twist if isnan(self.bearing) else (*twist, self.bearing)

    @classmethod
    def read(cls, numbers: tuple[float, ...]) -> Guidance:
        """Read a device's position: a twist, and perhaps more of what `numbers` gives.

        Raises BadGuidance.
        """
        given = len(numbers)
        if given not in (TWIST, WITH_BEARING, WITH_GOAL) and given < LED:
            raise BadGuidance(given)
        bearing = numbers[TWIST] if given > TWIST else nan
        goal = PlanarPose(*numbers[WITH_BEARING:WITH_GOAL]) if given >= WITH_GOAL else None
        plain = cls(np.array(numbers[:TWIST]), bearing, goal)
        return plain if given < LED else plain._with_lead(numbers)

    def _with_lead(self, numbers: tuple[float, ...]) -> Guidance:
        goal, rates = self.chair_goal, numbers[WITH_GOAL : WITH_GOAL + 2]
        return self._replace(
            chair_goal=None if goal is None or isnan(goal.x) else goal,
            chair_rates=None if isnan(rates[0]) else (rates[0], rates[1]),
            correction=np.array(numbers[LED - TWIST : LED]),
            posture=np.array(numbers[LED:]) if len(numbers) > LED else None,
        )

    def heading_wanted(self) -> float:
        """Give the bearing, else where the twist leads over the floor; nan when it leads nowhere.

        The twist is then taken in ground axes.
        """
        if not isnan(self.bearing):
            return self.bearing
        x, y = self.twist[:2].tolist()
        return atan2(y, x) if hypot(x, y) > 0.0 else nan
