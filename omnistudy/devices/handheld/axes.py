"""How the axes and buttons of a bought device move the three axes of the stick."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal, NamedTuple, Self

from pydantic import Field, model_validator

from omnistudy.devices.stick_scale import StickScale
from omnistudy.errors.handheld import NoSuchAxis
from omnistudy.registry import Model
from omnistudy.units import Metres, Positive, Radians, Ratio

FULL_COUNTS = 300.0
"""Counts of x and y at full deflection, where `rate` gives full speed (Tyagi 2017, App. B)."""
FULL_COUNTS_THETA = 250.0
"""Counts of theta where `rate` gives full speed: 3.0 / 0.012 (Tyagi 2017, App. B)."""


class HardwareAxis(NamedTuple):
    """An axis, trigger or button as its driver tells it, in the driver's own numbers.

    centre : where it rests; a button's and a trigger's is `low`.
    """

    name: str
    low: float
    centre: float
    high: float


class AxisRange(Model):
    """What an axis was found to tell at its ends and at rest, in its driver's own numbers."""

    low: Ratio
    centre: Ratio
    high: Ratio

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        if not (self.low <= self.centre <= self.high and self.low < self.high):
            raise ValueError(
                f"low {self.low:g}, centre {self.centre:g} and high {self.high:g} must rise"
            )
        return self

    def share(self, raw: float) -> float:
        """Give where `raw` lies between rest (0) and either end (-1, 1)."""
        if raw >= self.centre:
            span = self.high - self.centre
            return min(1.0, (raw - self.centre) / span) if span else 0.0
        span = self.centre - self.low
        return max(-1.0, (raw - self.centre) / span) if span else 0.0


class AxisMap(Model):
    """Which axis of the device moves one axis of the stick, and how.

    From the axis's number to the stick's deflection, -1 to 1: range, sign, dead zone, curve. The
    deflection is 0 inside the dead zone, begins at 0 at its border and is 1 at the end.
    """

    axis: str
    """Name of the axis, trigger, button or key; `omnistudy device monitor` shows them."""
    opposite: str = ""
    """What pulls the other way, where two buttons, triggers or keys make one axis."""
    sign: Literal[-1, 1] = 1
    """-1 for an axis that runs the other way: forward, left, counter-clockwise are positive."""
    range: AxisRange | None = None
    """As calibrated; without it what the driver says."""
    dead_zone: Annotated[Ratio, Field(ge=0, lt=1)] = 0.0
    """Part of the way from rest to the end that counts as rest."""
    exponent: Annotated[Ratio, Field(ge=0.25, le=4)] = 1.0
    """Above 1 is finer near the centre: deflection = share^exponent."""

    @model_validator(mode="after")
    def _range_of_one(self) -> Self:
        if self.opposite and self.range is not None:
            raise ValueError("range: a pair of axes has none; leave out 'range' or 'opposite'")
        return self

    def on(self, hardware: Sequence[HardwareAxis]) -> MappedAxis:
        """Find the axis on a device; raises NoSuchAxis."""
        names = [axis.name for axis in hardware]
        for name in (self.axis, self.opposite):
            if name and name not in names:
                raise NoSuchAxis(name, names)
        place = names.index(self.axis)
        opposite = names.index(self.opposite) if self.opposite else None
        return MappedAxis(
            place,
            opposite,
            self.range or _range(hardware[place]),
            None if opposite is None else _range(hardware[opposite]),
            self.sign,
            self.dead_zone,
            self.exponent,
        )


class MappedAxis(NamedTuple):
    """An `AxisMap` on one device; `place` and `opposite` count its axes."""

    place: int
    opposite: int | None
    range: AxisRange
    opposite_range: AxisRange | None
    sign: int
    dead_zone: float
    exponent: float

    def deflection(self, raw: Sequence[float]) -> float:
        """Give the stick's deflection, -1 to 1, from what all axes of the device tell."""
        share = self.range.share(raw[self.place])
        if self.opposite is not None and self.opposite_range is not None:
            share -= self.opposite_range.share(raw[self.opposite])
        size = abs(share)
        if size <= self.dead_zone:
            return 0.0
        bent: float = ((min(size, 1.0) - self.dead_zone) / (1.0 - self.dead_zone)) ** self.exponent
        return self.sign * (bent if share > 0 else -bent)


def _range(axis: HardwareAxis) -> AxisRange:
    return AxisRange(low=axis.low, centre=axis.centre, high=axis.high)


class Travel(Model):
    """Where the stick stands at full deflection: what controllers and laws see."""

    x: Annotated[Metres, Positive] = FULL_COUNTS * StickScale().metres_per_count
    """The travel of the thesis's stick, so that `rate` gives full speed at full deflection."""
    y: Annotated[Metres, Positive] = FULL_COUNTS * StickScale().metres_per_count
    theta: Annotated[Radians, Positive] = FULL_COUNTS_THETA * StickScale().radians_per_count
    """Where `rate` reaches full speed; the thesis's stick turns on, without effect."""
