"""The published study's comparison without rotational feedback."""

from __future__ import annotations

from typing import Literal

from omnistudy.laws.springs import SpringLaw, Touches


class ZeroTorqueLaw(SpringLaw):
    """The forces of the component law without any torque (Tyagi 2017, sec. 4.5, trial T10)."""

    kind: Literal["zero_torque"] = "zero_torque"

    def turning(self, touches: Touches, fx: float, fy: float) -> tuple[float, float]:
        """Give no torque and no damper of rotation."""
        return 0.0, 0.0
