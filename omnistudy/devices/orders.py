"""What the simulation and the process of a device tell each other, as fixed bytes.

Packed by `struct`: the device's process turns a thousand times a second.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

from omnistudy.devices.device import NO_HAND, DeviceState, Hand, Health
from omnistudy.geometry import NO_FORCE, ForceField, PlanarWrench
from omnistudy.geometry.force_field import Matrix3

LONGEST_TROUBLE = 400
"""Bytes of a trouble's sentence; the rest is cut off."""
FIELD_NUMBERS = 25


class Order(NamedTuple):
    """What the simulation wants now.

    trial : number of the trial, 0 between trials.
    opened : monotonic clock at its first step, s.
    fields : fields sent so far; another count means that `field` is new.
    """

    trial: int = 0
    opened: float = 0.0
    fields: int = 0
    field: ForceField = NO_FORCE
    hand: Hand = NO_HAND


class OrderLayout:
    """Orders to a device with so many axes, as bytes."""

    def __init__(self, axes: int) -> None:
        self._axes = axes
        self._struct = struct.Struct(f"<QdQ?{FIELD_NUMBERS + 4 * axes}d")
        self._nobody = (0.0,) * (4 * axes)
        self.size = self._struct.size

    def pack(self, order: Order) -> bytes:
        """Give the bytes of an order."""
        trial, opened, fields, field, hand = order
        held = bool(hand.reference)
        grip = (*hand[0], *hand[1], *hand[2], *hand[3]) if held else self._nobody
        wrench, about, (a, b, c), (d, e, f), valid_for = field
        return self._struct.pack(
            trial, opened, fields, held,
            *wrench, *about, *a, *b, *c, *d, *e, *f, valid_for, *grip,
        )  # fmt: skip

    def unpack(self, data: bytes) -> Order:
        """Give the order back."""
        trial, opened, fields, held, *numbers = self._struct.unpack(data)
        x, y, theta = numbers[:3]
        field = ForceField(
            PlanarWrench(x, y, theta),
            (numbers[3], numbers[4], numbers[5]),
            _matrix(numbers[6:15]),
            _matrix(numbers[15:24]),
            numbers[24],
        )
        if not held:
            return Order(trial, opened, fields, field)
        axes, grip = self._axes, tuple(numbers[FIELD_NUMBERS:])
        parts = (grip[start : start + axes] for start in range(0, 4 * axes, axes))
        return Order(trial, opened, fields, field, Hand(*parts))


class Report(NamedTuple):
    """What the process of a device says after each turn.

    turn : counted from 1. time : monotonic clock, s. trial : of the order that it follows.
    rows, health : of this trial, or of the last one: put into the ring, counted.
    """

    turn: int
    time: float
    trial: int
    rows: int
    health: Health
    state: DeviceState
    values: tuple[float, ...]
    trouble: str


class ReportLayout:
    """Reports of a device with so many axes and values, as bytes."""

    def __init__(self, axes: int, values: int) -> None:
        self._axes = axes
        self._struct = struct.Struct(
            f"<QdQQ QQQ {axes}Q {2 * axes}d {values}d H {LONGEST_TROUBLE}s".replace(" ", "")
        )
        self._unsaturated = (0,) * axes
        self.size = self._struct.size

    def pack(self, report: Report) -> bytes:
        """Give the bytes of a report."""
        turn, time, trial, rows, health, state, values, trouble = report
        words = trouble.encode()[:LONGEST_TROUBLE] if trouble else b""
        return self._struct.pack(
            turn, time, trial, rows, *health[:3], *(health.saturated or self._unsaturated),
            *state.position, *state.rate, *values, len(words), words,
        )  # fmt: skip

    def unpack(self, data: bytes) -> Report:
        """Give the report back."""
        turn, time, trial, rows, ticks, missed, damaged, *rest = self._struct.unpack(data)
        axes = self._axes
        return Report(
            turn,
            time,
            trial,
            rows,
            Health(ticks, missed, damaged, tuple(rest[:axes])),
            DeviceState(tuple(rest[axes : 2 * axes]), tuple(rest[2 * axes : 3 * axes])),
            tuple(rest[3 * axes : -2]),
            rest[-1][: rest[-2]].decode(errors="ignore"),
        )


def _matrix(numbers: list[float]) -> Matrix3:
    a, b, c, d, e, f, g, h, i = numbers
    return ((a, b, c), (d, e, f), (g, h, i))
