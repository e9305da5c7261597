"""How much of a path is done by when: linear, cubic, or blended at both ends."""

from __future__ import annotations

from math import sqrt
from typing import Annotated, Literal

from pydantic import Field

from omnistudy.registry import Model
from omnistudy.units import Ratio


class Timing(Model):
    """The share of a path over the share of its time (Farelo 2009, eq. 2 to 4)."""

    law: Literal["linear", "cubic", "blended"] = "blended"
    """`blended` speeds up, holds its speed and slows down: a trapezoid of speed."""
    blending: Annotated[Ratio, Field(ge=1)] = 5.0
    """b of eq. (3): 1 never holds its speed, infinity is linear; below 1, which the thesis allows,
    eq. (4) has no solution. 5 is that of the lab's program."""

    def share(self, u: float) -> float:
        """Give the share of the path (0 to 1) done when the share `u` of the time is gone."""
        if self.law == "linear":
            return u
        if self.law == "cubic":
            return u * u * (3.0 - 2.0 * u)
        blend, peak = self._blend, self.peak
        if u <= blend:
            return 2.0 * self.blending * u * u
        if u < 1.0 - blend:
            return peak * (u - 0.5 * blend)
        return 1.0 - 2.0 * self.blending * (1.0 - u) ** 2

    def rate(self, u: float) -> float:
        """Give the derivative of `share`, 1 being the mean speed."""
        if self.law == "linear":
            return 1.0
        if self.law == "cubic":
            return 6.0 * u * (1.0 - u)
        return min(self.peak, 4.0 * self.blending * min(u, 1.0 - u))

    @property
    def peak(self) -> float:
        """The greatest speed over the mean speed."""
        if self.law == "linear":
            return 1.0
        return 1.5 if self.law == "cubic" else 4.0 * self.blending * self._blend

    @property
    def _blend(self) -> float:
        """Share of the time that each blend takes, eq. (4)."""
        return 0.5 * (1.0 - sqrt(1.0 - 1.0 / self.blending))
