"""The thesis's first law for 128 rays: every spring turns the robot."""

from __future__ import annotations

from typing import Annotated, Literal

from annotated_types import Ge

from omnistudy.laws import published
from omnistudy.laws.springs import SpringLaw, Stiffness, Touches, TurningDamping
from omnistudy.units import Metres, TorqueStiffness

_ROUND_OFF = 1e-12
"""What summing leaves of two moments that cancel, as a part of either."""


class MomentStiffness(Stiffness):
    """Springs along the robot's axes and what each of the two turns."""

    theta_x: Annotated[TorqueStiffness, Ge(0.0)] = (
        315.0 * 37.5 / 24.0 * 100 * published.NEWTON_METRES_PER_COUNT
    )
    """Of those along x: 849.3 N·m/m². Eq. 4.5 multiplies both forces by one number, which appendix
    B has as 315 PWM per cm·m for those along y; those along x are 37.5/24 times as stiff."""

    theta_y: Annotated[TorqueStiffness, Ge(0.0)] = 315.0 * 100 * published.NEWTON_METRES_PER_COUNT
    """Of those along y: 315 PWM per cm·m of mean moment (appendix B, gainQ): 543.5 N·m/m²."""


class SpringDamperLaw(SpringLaw):
    """All springs turn the robot, as nature has it (Tyagi 2017, sec. 4.2, eq. 4.1-4.5).

    The thesis has this law in its text alone: appendix B holds only the component law. So
    `as_published` treats its two moments as that code treats its one.
    """

    kind: Literal["spring_damper"] = "spring_damper"

    stiffness: MomentStiffness = MomentStiffness()
    """Of the springs."""

    damping: TurningDamping = TurningDamping()
    """Of the dampers; each joins only where the spring part of its axis is not zero."""

    compliance_centre: Metres = 0.0
    """How far ahead of the robot's centre the compliance centre lies (sec. 4.5, Fig. 4.11)."""

    def turning(self, touches: Touches, fx: float, fy: float) -> tuple[float, float]:
        """Give mean(kx·px·y - ky·py·(x - c)) over the touching rays, and its damper."""
        ahead, across = touches.depth * touches.cos, touches.depth * touches.sin
        of_x = self.stiffness.theta_x * self.mean(ahead, touches.y)
        of_y = self.stiffness.theta_y * self.mean(across, touches.x - self.compliance_centre)
        tau = of_x - of_y
        cancelled = abs(tau) <= _ROUND_OFF * abs(of_x)
        return 0.0 if cancelled else tau, self.damping.theta
