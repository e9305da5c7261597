"""The six infrared range sensors of the first robot."""

from __future__ import annotations

from math import pi
from typing import Annotated, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from omnistudy.registry import KindModel
from omnistudy.scene import Sight
from omnistudy.units import Hertz, Metres, Positive, Radians, Ratio


class InfraredRing(KindModel):
    """Six triangulating range sensors: 1 left, 2 oblique front left, 3 and 4 ahead, 5, 6 mirrored.

    What they do is Tyagi 2017, sec. 2.3; where they sit is lost with Fig. 2.7, so every number
    here is ours. Sensors 4 to 6 mirror 3 to 1.
    """

    kind: Literal["infrared_ring"] = "infrared_ring"
    oblique: Annotated[Radians, Field(ge=0, le=pi / 2)] = pi / 4
    """Direction of sensors 2 and 5, from square to the side towards ahead (theta of eq. 2.4)."""
    oblique_ahead: Metres = 0.20
    """Where sensors 2 and 5 sit, from the robot's centre (a of eq. 2.4)."""
    oblique_aside: Annotated[Metres, Field(ge=0)] = 0.10
    """Where sensors 2 and 5 sit, from the middle line (b of eq. 2.4)."""
    front_ahead: Metres = 0.20
    """Where sensors 3 and 4 sit, from the robot's centre."""
    front_aside: Annotated[Metres, Field(ge=0)] = 0.05
    """Where sensors 3 and 4 sit, from the middle line."""
    side_ahead: Metres = 0.0
    """Where sensors 1 and 6 sit, from the robot's centre."""
    side_aside: Annotated[Metres, Field(ge=0)] = 0.18
    """Where sensors 1 and 6 sit, from the middle line."""
    height: Annotated[Metres, Positive] = 0.2
    """Above the floor; low blocks are not seen."""
    min_range: Annotated[Metres, Field(ge=0)] = 0.04
    """What is nearer reads as this. A sensor of this make reads as farther there; left out."""
    max_range: Annotated[Metres, Positive] = 0.8
    """A reading from here on is no detection."""
    noise: Annotated[Metres, Field(ge=0)] = 0.02
    """SD of one reading at `max_range`. Such a sensor's voltage falls with 1/distance, so a steady
    noise of the voltage makes an SD that grows with the square of the distance."""
    readings: Annotated[int, Field(ge=1, le=1000)] = 8
    """Averaged in every scan."""
    cutoff: Annotated[Hertz, Positive] = 8.0
    """Of the first-order low-pass that follows the average."""
    interference: Annotated[Ratio, Field(ge=0, le=1)] = 0.02
    """Chance in a scan that a sensor reads a neighbour's reflection as its own, when both see
    something within `interference_range`. Neighbours are those beside it in the ring, met equally
    often; 1 and 6 have one each, as nothing looks back."""
    interference_range: Annotated[Metres, Positive] = 0.4
    """How near both must see something."""
    rates_from: Literal["encoders", "ranges"] = "encoders"
    """Where each range's rate comes from: the wheels' encoders, as if only the robot moved and all
    stood square to the rays (sec. 2.3), or differences of the filtered range."""

    @model_validator(mode="after")
    def _ranges_are_in_order(self) -> Self:
        if self.min_range >= self.max_range:
            raise ValueError(
                f"min_range {self.min_range:g} m must be below max_range {self.max_range:g} m"
            )
        return self

    @property
    def angles(self) -> NDArray[np.float64]:
        """(6,) rad, robot frame, counter-clockwise: sensors 1 to 6."""
        left = np.array([pi / 2, pi / 2 - self.oblique, 0.0])
        return np.concatenate([left, -left[::-1]])

    @property
    def origins(self) -> NDArray[np.float64]:
        """(6, 2) m, robot frame: where sensors 1 to 6 sit."""
        left = np.array(
            [
                [self.side_ahead, self.side_aside],
                [self.oblique_ahead, self.oblique_aside],
                [self.front_ahead, self.front_aside],
            ]
        )
        return np.concatenate([left, left[::-1] * (1.0, -1.0)])

    @property
    def sight(self) -> Sight:
        """Its rays, as they would be without noise."""
        return Sight(
            origins=tuple((float(x), float(y)) for x, y in self.origins),
            angles=tuple(self.angles.tolist()),
            height=self.height,
            max_range=self.max_range,
        )
