"""What the axes of a bought device tell at rest and at their ends, as its page says it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.devices.handheld.axes import AxisMap, AxisRange, HardwareAxis
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.errors.handheld import DidNotMove, Unsteady

AxisName = Literal["x", "y", "theta"]
AXES: tuple[AxisName, ...] = ("x", "y", "theta")
WAYS: Mapping[AxisName, tuple[str, str]] = {
    "x": ("all the way back", "all the way forward"),
    "y": ("all the way right", "all the way left"),
    "theta": ("clockwise as far as it goes", "counter-clockwise as far as it goes"),
}
"""The negative and the positive end of each axis."""
HELD_S = 1.0
"""How long each step is recorded (ours)."""
REACH = 0.98
"""Part of the way to the held end that already counts as full, so that full is reached (ours)."""
NOISES = 3.0
"""A dead zone holds so many times the greatest stray at rest, or what the page has (ours)."""
STILL = 0.2
"""More stray than this part of the way is a hand that did not let go (ours)."""
MOVED = 0.2
"""Less than this part of the driver's range is an axis that was not moved (ours)."""


class Step(NamedTuple):
    """Something to do with the device: nothing (`axis` None), or hold an axis at an end."""

    axis: AxisName | None
    positive: bool
    instruction: str


class Recorded(NamedTuple):
    """What all axes of the device told during a step: (samples, axes), in its own numbers."""

    step: Step
    raw: NDArray[np.float64]


class AxisFound(NamedTuple):
    """One axis of the stick; `noise` and `dead_zone` are shares of the way from rest to the end."""

    axis: AxisName
    moved_by: str
    low: float
    centre: float
    high: float
    sign: Literal[-1, 1]
    noise: float
    dead_zone: float


def steps_of(device: Handheld) -> tuple[Step, ...]:
    """Give what is to be done; axes that are pairs of buttons need nothing."""
    rest = Step(None, False, "let go of it")
    ends = [
        Step(axis, positive, f"hold it {WAYS[axis][positive]}")
        for axis, one in zip(AXES, device.maps, strict=True)
        if not one.opposite
        for positive in (True, False)
    ]
    return (rest, *ends) if ends else ()


def found_in(
    device: Handheld, hardware: tuple[HardwareAxis, ...], recorded: tuple[Recorded, ...]
) -> tuple[AxisFound, ...]:
    """Give range, sign and noise of each axis; raises DidNotMove or Unsteady."""
    at_rest = next(one.raw for one in recorded if one.step.axis is None)
    held = {(one.step.axis, one.step.positive): one.raw for one in recorded}
    return tuple(
        _found(axis, one, hardware, at_rest, held[axis, False], held[axis, True])
        for axis, one in zip(AXES, device.maps, strict=True)
        if not one.opposite
    )


def calibrated(device: Handheld, found: tuple[AxisFound, ...], made: str) -> Handheld:
    """Give the device with what was found; `made` says when and on which hardware."""
    maps = dict(zip(AXES, device.maps, strict=True))
    changed: dict[str, object] = {
        one.axis: maps[one.axis].model_copy(
            update={
                "sign": one.sign,
                "dead_zone": one.dead_zone,
                "range": AxisRange(low=one.low, centre=one.centre, high=one.high),
            }
        )
        for one in found
    }
    return device.model_copy(update={**changed, "calibrated": made})


def _found(
    axis: AxisName,
    mapped: AxisMap,
    hardware: tuple[HardwareAxis, ...],
    at_rest: NDArray[np.float64],
    at_minus: NDArray[np.float64],
    at_plus: NDArray[np.float64],
) -> AxisFound:
    place = [one.name for one in hardware].index(mapped.axis)
    centre = float(np.median(at_rest[:, place]))
    minus, plus = (float(np.median(raw[:, place])) for raw in (at_minus, at_plus))
    for end, raw, way in ((plus, at_plus, WAYS[axis][1]), (minus, at_minus, WAYS[axis][0])):
        if abs(end - centre) < MOVED * _half(hardware[place]):
            raise DidNotMove(mapped.axis, way, _moved_most(hardware, at_rest, raw))
    if (plus - centre) * (minus - centre) > 0.0:
        raise DidNotMove(mapped.axis, "to two different ends", "")
    low, high = sorted((minus, plus))
    stray = float(np.abs(at_rest[:, place] - centre).max())
    noise = stray / min(high - centre, centre - low)
    if noise > STILL:
        raise Unsteady(mapped.axis, noise)
    return AxisFound(
        axis,
        mapped.axis,
        round(centre + REACH * (low - centre), 3),
        round(centre, 3),
        round(centre + REACH * (high - centre), 3),
        1 if plus > minus else -1,
        noise,
        max(mapped.dead_zone, round(NOISES * noise, 3)),
    )


def _half(axis: HardwareAxis) -> float:
    return 0.5 * (axis.high - axis.low)


def _moved_most(
    hardware: tuple[HardwareAxis, ...], at_rest: NDArray[np.float64], held: NDArray[np.float64]
) -> str:
    """Name the axis that moved instead; "" for none."""
    halves = np.array([_half(axis) for axis in hardware])
    shares = np.abs(np.median(held, axis=0) - np.median(at_rest, axis=0)) / halves
    most = int(np.argmax(shares))
    return hardware[most].name if shares[most] >= MOVED else ""
