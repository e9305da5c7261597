"""What laws share whose torque follows the quadrant in which the springs' force lies."""

from __future__ import annotations

from abc import abstractmethod
from math import hypot
from typing import Annotated

from annotated_types import Ge

from omnistudy.laws.springs import SpringLaw, Touches, TurningDamping
from omnistudy.units import Metres, Ratio


class ForceQuadrantLaw(SpringLaw):
    """The springs' force turns the robot on an arm, away from the quadrant that holds the obstacle.

    The thesis draws forward up and right to the right: the force turns counter-clockwise in its
    quadrants I and III. With x forward and y left those are II and IV.
    """

    damping: TurningDamping = TurningDamping()
    """Of the dampers; each joins only where the spring part of its axis is not zero."""

    arm: Annotated[Metres, Ge(0.0)] = 0.10
    """r_a of eq. 4.7."""

    gain: Annotated[Ratio, Ge(0.0)] = 1.0
    """k of eq. 4.6; ours: the thesis gives none."""

    @abstractmethod
    def share(self, fx: float, fy: float) -> float:
        """Give how much of the full torque a force in N has, -1 to 1, above zero in I and III."""

    def turning(self, touches: Touches, fx: float, fy: float) -> tuple[float, float]:
        """Give -k·f·r_a·share, f being the size of the springs' force, and its damper."""
        force = hypot(fx, fy)
        share = self.share(fx, fy) if force else 0.0
        return 0.0 - self.gain * force * self.arm * share, self.damping.theta
