"""The quadrant law without its jumps."""

from __future__ import annotations

from typing import Literal

from omnistudy.laws.quadrants import ForceQuadrantLaw


class QuadrantSmoothedLaw(ForceQuadrantLaw):
    """The force turns the robot by the sine of twice its angle (Tyagi 2017, sec. 4.3, Fig. 4.7).

    The torque is zero where the force lies along an axis and full at 45 degrees between them. The
    thesis has this law in its text alone; `as_published` concerns the springs.
    """

    kind: Literal["quadrant_smoothed"] = "quadrant_smoothed"

    def share(self, fx: float, fy: float) -> float:
        """Give sin(2·atan2(fy, fx))."""
        return 2.0 * fx * fy / (fx * fx + fy * fy)
