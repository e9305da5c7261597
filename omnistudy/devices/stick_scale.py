"""How far the stick's encoders turn for a given motion of the handle."""

from __future__ import annotations

from math import pi
from typing import Annotated

from omnistudy.registry import Model
from omnistudy.units import Metres, Positive, Ratio

FULL_DUTY = 255.0
"""PWM counts a motor gets at most."""
FORCE_AT_FULL_DUTY = 13.5
"""N at the handle, x and y (Tyagi 2017, ch. 2); 15 x 85.6 mN·m on 0.095 m."""
TORQUE_AT_FULL_DUTY = 4.4
"""N·m about the handle as published, though 15 x 85.6 mN·m is 1.28 N·m."""


class StickScale(Model):
    """Counts per degree of the handle and the handle's length (Tyagi 2017, App. B).

    The thesis's three counts-per-degree figures disagree with its 15:1 capstan and 1440 counts per
    turn (60 per degree); they are kept as the firmware has them.
    """

    counts_per_degree_x: Annotated[Ratio, Positive] = 12.0
    counts_per_degree_theta: Annotated[Ratio, Positive] = 4.0
    """1440 counts per turn of the handle."""
    lever: Annotated[Metres, Positive] = 0.095
    """Handle length at which 15 x 85.6 mN·m gives the published 13.5 N."""

    @property
    def metres_per_count(self) -> float:
        """Handle travel in x or y, m per encoder count."""
        return self.lever * pi / 180.0 / self.counts_per_degree_x

    @property
    def radians_per_count(self) -> float:
        """Handle twist, rad per encoder count."""
        return pi / 180.0 / self.counts_per_degree_theta
