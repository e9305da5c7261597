"""What a stick's PWM steps were found to be in newtons, as its page says."""

from __future__ import annotations

from datetime import date
from hashlib import sha256
from typing import Annotated

from pydantic import Field

from omnistudy.errors.force_calibration import CalibrationOfAnother
from omnistudy.registry import Model
from omnistudy.units import Positive, Ratio


class AxisForce(Model):
    """One axis: force = offset + per_duty·(duty - dead_band), beyond the dead band, either way.

    N and N per PWM step; N·m for theta.
    """

    per_duty: Annotated[Ratio, Positive]
    """N (theta: N·m) that each PWM step beyond the dead band adds."""
    per_duty_95: Annotated[Ratio, Field(ge=0)]
    """Half the width of its 95 % confidence interval."""
    dead_band: Annotated[Ratio, Field(ge=0, lt=255)] = 0.0
    """PWM steps that friction and amplifier take before any force is felt."""
    offset: Ratio = 0.0
    """What the instrument read without force, N (theta: N·m)."""
    greatest: Annotated[int, Field(ge=1, le=255)]
    """PWM steps up to which it was measured."""
    prediction_95: Annotated[Ratio, Field(ge=0)]
    """Half the width of the 95 % interval of one more reading at `greatest`, N (theta: N·m)."""
    readings: Annotated[int, Field(ge=1)]
    """How many."""


class ForceCalibration(Model):
    """A calibration with a load cell or a spring scale; a stick that names it is calibrated."""

    date: date
    """When it was made."""
    who: Annotated[str, Field(max_length=5)] = ""
    """Initials of who made it, or nothing."""
    instrument: str
    """What was read, with its own accuracy."""
    serial: str = ""
    """Serial number of the stick; "" fits every stick."""
    x: AxisForce
    """Forward."""
    y: AxisForce
    """To the left."""
    theta: AxisForce
    """Counter-clockwise."""

    @property
    def axes(self) -> tuple[AxisForce, AxisForce, AxisForce]:
        """The three axes, x, y, theta."""
        return (self.x, self.y, self.theta)

    @property
    def name(self) -> str:
        """Date and first eight digits of the content's SHA-256, as the data say it."""
        content = self.model_dump_json().encode()
        return f"{self.date.isoformat()} {sha256(content).hexdigest()[:8]}"

    def check_serial(self, serial: str) -> None:
        """Make sure that it is this stick's; raises CalibrationOfAnother."""
        if self.serial and self.serial != serial:
            raise CalibrationOfAnother(self.serial, serial or "unknown")
