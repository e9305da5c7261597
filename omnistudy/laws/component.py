"""The law of the published study: only the y springs turn the robot."""

from __future__ import annotations

from typing import Annotated, Literal

from annotated_types import Ge

from omnistudy.laws import published
from omnistudy.laws.springs import SpringLaw, Stiffness, Touches, TurningDamping
from omnistudy.units import Metres, TorqueStiffness


class TurningStiffness(Stiffness):
    """Springs along the robot's axes and what those along y turn."""

    theta: Annotated[TorqueStiffness, Ge(0.0)] = 315.0 * 100 * published.NEWTON_METRES_PER_COUNT
    """315 PWM per cm·m of mean moment (appendix B, gainQ = 2100·0.15): 543.5 N·m/m²."""


class ComponentLaw(SpringLaw):
    """Only the y springs turn the robot: the "Fy law" (Tyagi 2017, sec. 4.4, eq. 4.8)."""

    kind: Literal["component"] = "component"

    stiffness: TurningStiffness = TurningStiffness()
    """Of the springs."""

    damping: TurningDamping = TurningDamping()
    """Of the dampers; each joins only where the spring part of its axis is not zero."""

    compliance_centre: Metres = 0.0
    """How far ahead of the robot's centre the compliance centre lies (sec. 4.5, Fig. 4.11)."""

    def turning(self, touches: Touches, fx: float, fy: float) -> tuple[float, float]:
        """Give mean(-k·py·(d·cos a - c)) over the touching rays, and its damper."""
        across = touches.depth * touches.sin
        arm = touches.x - self.compliance_centre
        return 0.0 - self.stiffness.theta * self.mean(across, arm), self.damping.theta
