"""The law of the thesis's first study: the quadrant of the force says which way to turn."""

from __future__ import annotations

from typing import Literal

from omnistudy.laws.quadrants import ForceQuadrantLaw


class QuadrantLaw(ForceQuadrantLaw):
    """The force turns the robot fully one way or the other (Tyagi 2017, sec. 4.3, eq. 4.6-4.7).

    The torque jumps where the force crosses an axis (Fig. 4.6). The thesis has this law in its text
    alone; `as_published` concerns the springs, whose torque is not rounded again.
    """

    kind: Literal["quadrant"] = "quadrant"

    def share(self, fx: float, fy: float) -> float:
        """Give the sign of fx·fy."""
        if not fx or not fy:
            return 0.0
        return 1.0 if (fx > 0.0) == (fy > 0.0) else -1.0
