"""How often physics, scan and samples tick."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from omnistudy.registry.model import Model


class Recording(Model):
    """Rates in Hz. Physics is the fastest; samples are taken every whole number of steps."""

    physics_hz: Annotated[int, Field(ge=60, le=1000)] = 240
    """PyBullet's own default step."""
    scan_hz: Annotated[int, Field(ge=1, le=240)] = 50
    """Lidar and law; real lidars give 40-50 Hz (Tyagi 2017, sec. 2.4)."""
    sample_hz: Annotated[int, Field(ge=1, le=240)] = 20
    """Rows of the `sample` table; the metrics need at least 20."""

    @model_validator(mode="after")
    def _ticks_fit(self) -> Self:
        if self.physics_hz % self.sample_hz:
            raise ValueError(f"sample_hz {self.sample_hz} must divide physics_hz {self.physics_hz}")
        if self.scan_hz > self.physics_hz:
            raise ValueError(f"scan_hz {self.scan_hz} is above physics_hz {self.physics_hz}")
        return self
