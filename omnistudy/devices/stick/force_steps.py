"""Leads a stick through steps of force while an instrument is read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from omnistudy.devices.stick.force_fit import Reading
from omnistudy.devices.stick.layouts import SCALES
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Configuration, Fault, Field, State, Telemetry
from omnistudy.errors.devices import NoTelemetry
from omnistudy.errors.force_calibration import ForceWithdrawn, HandleMoved, NothingRead

AXES = ("x", "y", "theta")
RENEWED = 0.05
"""s between two fields of the same force (ours)."""
VALID_FOR = 250
"""ms, the longest: a program that dies leaves no force behind."""
SOFT_START = 300
"""ms until a step has all its force (ours)."""
SILENCE = 1000
"""ms, the longest that the firmware allows: a field is stale long before."""
SETTLING = 0.5
"""s that the force stands before the instrument is read (ours)."""
SETTLED_WITHIN = 3.0
"""s until a step must have come whole (ours)."""
SILENT_AFTER = 0.5
"""s without telemetry that end it (ours)."""
LONGEST = 30.0
"""s that a step is held at most, for the motors' sake (ours)."""
MOST_COUNTS = 30
"""Counts that the handle may give way: a tenth of its travel (ours)."""
NONE3, NONE9 = (0,) * 3, (0,) * 9

Instrument = Callable[[], float | None]
"""What is read: the force in N (theta: N·m), or None while the reading is not there yet."""
Tell = Callable[[int, int], None]
"""Told the axis and PWM steps that come now."""


class Plan(NamedTuple):
    """Which steps are taken.

    greatest : PWM steps. levels : sizes of step, evenly spaced up to it.
    """

    greatest: int = 200
    levels: int = 4

    def duties(self) -> tuple[int, ...]:
        """Give the steps of an axis: up, both ways in turns, then down again.

        So a drift of the instrument, or friction, does not look like slope.
        """
        sizes = [round(self.greatest * n / self.levels) for n in range(1, self.levels + 1)]
        up = [duty for size in sizes for duty in (size, -size)]
        return (0, *up, *(-duty for duty in reversed(up)), 0)

    def total(self) -> int:
        """Tell how many readings there are of all axes."""
        return len(AXES) * len(self.duties())


def measure(
    line: StickLine, instruments: Sequence[Instrument], plan: Plan, tell: Tell
) -> list[Reading]:
    """Take every step on every axis and give what was read.

    instruments : one an axis. The stick's own force is off meanwhile, and its settings are as they
    were afterwards.
    Raises Refused, NoAnswer, NoTelemetry, ForceWithdrawn, HandleMoved, NothingRead.
    """
    line.clear_faults()
    before = line.configuration()
    line.configure(_without_own_force(before))
    try:
        return [
            Reading(axis, duty, _read(line, axis, duty, instruments[axis], tell))
            for axis in range(len(AXES))
            for duty in plan.duties()
        ]
    finally:
        line.disarm()
        line.configure(before)


def _without_own_force(settings: Configuration) -> Configuration:
    return settings._replace(
        centring_stiffness=NONE3, centring_damping=NONE3, gravity=NONE3, soft_start=SOFT_START,
        silence=SILENCE,
    )  # fmt: skip


def _read(line: StickLine, axis: int, duty: int, instrument: Instrument, tell: Tell) -> float:
    """Hold one step until it was read; no force is left afterwards."""
    tell(axis, duty)
    line.arm()
    began = even_since = line.transport.now()
    stood = _hold(line, axis, duty).position[axis]
    while (now := line.transport.now()) < began + LONGEST:
        told = _hold(line, axis, duty)
        _insist(axis, duty, told, stood)
        if told.motor[axis] != duty:
            even_since = now
            if now > began + SETTLED_WITHIN:
                raise ForceWithdrawn(AXES[axis], duty, f"its settings allow {told.motor[axis]:+d}")
        elif now > even_since + SETTLING and (force := instrument()) is not None:
            line.disarm()
            return force
    raise NothingRead(AXES[axis], duty, LONGEST)


def _insist(axis: int, duty: int, told: Telemetry, stood: int) -> None:
    """Make sure that the stick pushes and stands still; raises ForceWithdrawn, HandleMoved."""
    if told.state not in (State.RISING, State.FORCE):
        faults = Fault(told.faults).name or "no fault"
        raise ForceWithdrawn(AXES[axis], duty, f"{State(told.state).name}, {faults}")
    moved = abs(told.position[axis] - stood)
    if moved > MOST_COUNTS:
        raise HandleMoved(AXES[axis], duty, moved, MOST_COUNTS)


def _hold(line: StickLine, axis: int, duty: int) -> Telemetry:
    """Renew the field and give the last telemetry; raises NoTelemetry."""
    wrench = [0, 0, 0]
    wrench[axis] = duty * SCALES[Field]["wrench"]
    x, y, theta = wrench
    line.send(Field((x, y, theta), NONE3, NONE9, NONE9, VALID_FOR))
    for _ in range(round(SILENT_AFTER / RENEWED)):
        heard = line.listen(RENEWED)
        if heard:
            return heard[-1]
    raise NoTelemetry(SILENT_AFTER)
