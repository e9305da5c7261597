"""Moves a stick that nobody holds, slowly and with little force, to find out how it moves."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from omnistudy.devices.stick.layouts import SCALES
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import (
    Configuration,
    Fault,
    Field,
    Nine,
    State,
    Telemetry,
    Three,
)
from omnistudy.errors.devices import NoTelemetry
from omnistudy.errors.stick_checks import ForceGone

FORCE = 96
"""PWM steps that any motor gets at most: 5 N nominal (ours)."""
PUSH = 57
"""PWM steps of a push: 3 N nominal, more than the 2.2 N that the handle weighs on its
stop (ours)."""
SLOWLY = 57
"""PWM·ms/count of damping: a push then moves a count a millisecond, 0.14 m/s (ours)."""
SPRING = 0.5
"""PWM/count towards where the stick is to go (ours)."""
STEP = 20
"""Counts by which the spring's end moves with each field: a count a millisecond (ours)."""
SOFT_START = 50
"""ms (ours)."""
RENEWAL = 0.02
"""s between two fields."""
LONGEST_SILENCE = 0.4
"""s without telemetry on a busy host; the stick has no force after 0.3 s of its own (ours)."""
FAR_ENOUGH = 10
"""Counts that end a push (ours)."""
PUSH_WITHIN = 0.15
"""s; the nominal mechanism needs 12 ms (ours)."""
STANDS = 2
"""Counts within which it stands still (ours)."""
STILL_FOR = 8
"""Fields for which it must stand still: 0.16 s (ours)."""
MOVE_WITHIN = 8.0
"""s for one motion; from stop to stop theta needs 3 s (ours)."""
NONE: Three = (0, 0, 0)
WIDEST: Three = (2047, 2047, 2047)
"""Counts: the greatest travel that the protocol takes."""


class Stops(NamedTuple):
    """Where an axis could not go any further, counts."""

    low: int
    high: int

    @property
    def middle(self) -> int:
        """Where the zero should be."""
        return round((self.low + self.high) / 2)

    @property
    def travel(self) -> int:
        """Either way from the middle."""
        return round((self.high - self.low) / 2)


@contextmanager
def low_force(line: StickLine, settings: Configuration) -> Iterator[None]:
    """Arm the stick with little force and none of its own; disarm it afterwards.

    Its zero may be anywhere, so neither its travel nor the weight of its angle is known.

    Raises Refused, NoAnswer.
    """
    line.configure(
        settings._replace(
            centring_stiffness=NONE, centring_damping=NONE, gravity=NONE, travel=WIDEST,
            force_limit=limited(settings), soft_start=SOFT_START,
        )
    )  # fmt: skip
    line.arm()
    _render(line, device_field(), 2 * SOFT_START / 1000)
    try:
        yield
    finally:
        line.disarm()


def limited(settings: Configuration) -> Three:
    """Give the force limits of these motions, PWM steps."""
    x, y, theta = (min(FORCE, limit) for limit in settings.force_limit)
    return (x, y, theta)


def moved_by_a_push(line: StickLine, axis: int) -> int:
    """Push an axis until it has moved a little; give by how many counts along the push.

    A stick that leans on a stop cannot move that way, so it is pushed the other way too.
    """
    there = _moved(line, axis, PUSH)
    return there if abs(there) >= FAR_ENOUGH else max(there, -_moved(line, axis, -PUSH), key=abs)


def _moved(line: StickLine, axis: int, push: int) -> int:
    start = _until_still(line, device_field())[axis]  # it may be falling to its stop
    field = device_field(wrench=along(axis, push))
    moved = 0
    for _ in range(round(PUSH_WITHIN / RENEWAL)):
        ways = (told.position[axis] - start for told in _render(line, field, RENEWAL))
        moved = max(moved, *ways, key=abs)
        if abs(moved) >= FAR_ENOUGH:
            break
    return moved


def stops_of(line: StickLine, axis: int) -> Stops:
    """Move an axis to both of its stops."""
    low, high = (
        _until_still(line, device_field(wrench=along(axis, way * PUSH), damping=SLOWLY))[axis]
        for way in (-1, 1)
    )
    return Stops(low, high)


def go_to(line: StickLine, counts: Three) -> Three:
    """Move the stick there; give where it then stands, counts.

    The spring's end moves, not the stick alone: a far one would be faster than the velocity trip.
    """
    at = _render(line, device_field(damping=SLOWLY), RENEWAL)[-1].position
    steps = max(abs(a - b) for a, b in zip(at, counts, strict=True)) // STEP + 1
    for step in range(1, steps + 1):
        x, y, theta = (a + (b - a) * step // steps for a, b in zip(at, counts, strict=True))
        there: Three = (x, y, theta)
        _render(line, device_field(about=there, stiffness=SPRING, damping=SLOWLY), RENEWAL)
    return _until_still(line, device_field(about=counts, stiffness=SPRING, damping=SLOWLY))


def rest_after_a_push(line: StickLine) -> Three:
    """Push the stick away and let its own forces work; give where it then stands, counts."""
    _render(line, device_field(wrench=(PUSH, PUSH, PUSH)), PUSH_WITHIN)
    return _until_still(line, device_field())


def _until_still(line: StickLine, field: Field) -> Three:
    before: Three = NONE
    still = 0
    for _ in range(round(MOVE_WITHIN / RENEWAL)):
        now = _render(line, field, RENEWAL)[-1].position
        moved = max(abs(a - b) for a, b in zip(now, before, strict=True))
        still, before = (still + 1, before) if moved <= STANDS else (0, now)
        if still >= STILL_FOR:
            break
    return now


def heard_now(line: StickLine, seconds: float) -> list[Telemetry]:
    """Listen for so long, and longer while nothing comes: at least one frame; else NoTelemetry."""
    heard = line.listen(seconds)
    waited = 0.0
    while not heard:
        if waited >= LONGEST_SILENCE:
            raise NoTelemetry(LONGEST_SILENCE)
        heard = line.listen(RENEWAL)
        waited += RENEWAL
    return heard


def _render(line: StickLine, field: Field, seconds: float) -> list[Telemetry]:
    heard: list[Telemetry] = []
    for _ in range(max(1, round(seconds / RENEWAL))):
        line.send(field)
        heard += line.listen(RENEWAL)
    if not heard:
        heard = heard_now(line, 0.0)
    last = heard[-1]
    if last.state in (State.IDLE, State.FAULT):
        raise ForceGone(State(last.state).name, Fault(last.faults).name or "no fault")
    return heard


def along(axis: int, push: float) -> tuple[float, float, float]:
    """Give a push along one axis."""
    x, y, theta = (push if axis == one else 0.0 for one in range(3))
    return (x, y, theta)


def device_field(
    wrench: tuple[float, float, float] = NONE,
    about: Three = NONE,
    stiffness: float = 0.0,
    damping: float = 0.0,
) -> Field:
    """Give a field in wire steps from PWM, counts, PWM/count and PWM·ms/count."""
    steps = SCALES[Field]

    def times(values: tuple[float, float, float], scale: int) -> Three:
        x, y, theta = (round(value * scale) for value in values)
        return (x, y, theta)

    def diagonal(value: float, scale: int) -> Nine:
        one = round(value * scale)
        return (one, 0, 0, 0, one, 0, 0, 0, one)

    return Field(
        times(wrench, steps["wrench"]),
        times(about, steps["about"]),
        diagonal(stiffness, steps["stiffness"]),
        diagonal(damping, steps["damping"]),
        valid_for=round(5 * RENEWAL * 1000),
    )
