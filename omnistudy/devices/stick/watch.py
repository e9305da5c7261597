"""Watches what a stick tells while somebody drives with it: telemetry in, trouble out.

What a hand could do as well as a fault is not told here but by `checks`; docs/safety.md lists both.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from omnistudy.devices.stick.messages import (
    TICK_HZ,
    Fault,
    Identity,
    State,
    Telemetry,
    Three,
)

AXES = ("x", "y", "theta")
SILENT_AFTER = 0.05
"""s without a frame until the line counts as dead: 50 frames (ours)."""
WINDOW = 0.5
"""s over which the rate of telemetry is taken; a lower rate is told after two at most (ours)."""
LEAST_SHARE = 0.8
"""Of the frames that should have come in a window (ours)."""
LONGEST_ABSENCE = 0.05
"""s between two looks; a window in which nobody looked says nothing about the stick (ours)."""
MOST_GLITCHES = 10
"""Illegal encoder steps since the last checks: each may be two counts (ours)."""
BEYOND_STOP = 1.05
"""Times its mechanical stop a stick can stand at only if its counts are wrong (ours)."""
AT_STOP = 0.95
"""Times its mechanical stop from where on the stop may be what holds the stick (ours)."""
FROZEN_FORCE = 60
"""PWM (3.2 N nominal) by which force changes without a count: a hand of 23 kN/m, or no encoder
(ours; static friction must stay below it)."""
FROZEN_TICKS = 100
"""Ticks that this must have lasted at least, so that the handle had time to move (ours)."""
SATURATED_TICKS = 10 * TICK_HZ
"""Ticks without a break at an axis' limit (ours)."""
ASK_AFTER_RESTART = 0.02
"""s that are waited for the reason of a new start (ours)."""
ARM_WITHIN = 0.1
"""s from a trial's beginning until a stick that was let go in the rest has force again (ours)."""
SOFT = (State.IDLE, State.FAULT)
RESET_CAUSES = {1: "its power came back", 2: "its reset line", 4: "a brown-out", 8: "its watchdog"}
"""MCUSR of an ATmega2560; a bootloader may clear it."""


class _Axis:
    """What is remembered of an axis."""

    def __init__(self, told: Telemetry, axis: int) -> None:
        self.position = told.position[axis]
        self.since = told.tick
        self.least = self.most = told.motor[axis]
        self.free_since = told.tick


class Expected(NamedTuple):
    """What the stick was at its last checks.

    stops : mechanical stops, encoder counts either way. limits : PWM steps of each motor.
    """

    identity: Identity
    stops: Three
    limits: Three


class Watch:
    """Judges frame by frame; what it found first, it says for good.

    resting : no trial goes on, and a stick that is soft is no trouble.
    """

    def __init__(self, expected: Expected, now: float) -> None:
        self._expected = expected
        self._last: Telemetry | None = None
        self._axes: tuple[_Axis, ...] = ()
        self._heard_at = self._looked_at = self._window_from = now
        self._frames = 0
        self._whole_window = True
        self._glitches = 0
        self._restarted_at: float | None = None
        self._armed_by: float | None = None
        self.resting = False
        self.trouble = ""

    def begin(self, now: float) -> None:
        """Forget the time before: the stick is armed, or at rest, from `now` on."""
        self._heard_at = self._looked_at = self._window_from = now
        self._frames = 0

    def wake(self, now: float) -> None:
        """Have a rest end: the stick must have force again soon."""
        self.resting = False
        self._armed_by = now + ARM_WITHIN

    @property
    def asks(self) -> bool:
        """Whether the stick should be asked who it is, for it has started anew."""
        return self._restarted_at is not None and not self.trouble

    def look(self, heard: Sequence[Telemetry], now: float) -> str:
        """Take what came since the last look, at `now` s of the line; give the trouble or ""."""
        if self.trouble:
            return self.trouble
        for told in heard:
            if self._restarted_at is None:
                self.trouble = self._judge(told)
            if self.trouble:
                return self.trouble
        self._count(len(heard), now)
        return self.trouble

    def meet(self, identity: Identity) -> str:
        """Take what the stick says about who it is; give the trouble or ""."""
        if self.trouble:
            return self.trouble
        expected = self._expected.identity
        if (identity.serial, identity.firmware) != (expected.serial, expected.firmware):
            self.trouble = (
                f"another stick was plugged in: serial number {identity.serial} with firmware "
                f"{identity.firmware:08x} instead of {expected.serial} with {expected.firmware:08x}"
            )
        elif self._restarted_at is not None:
            cause = RESET_CAUSES.get(identity.reset_cause, "for an unknown reason")
            self.trouble = f"the stick started anew ({cause})"
        return self.trouble

    def _judge(self, told: Telemetry) -> str:
        last, self._last = self._last, told
        if last is None:
            self._axes = tuple(_Axis(told, axis) for axis in range(3))
            return self._state(told)
        if told.tick < last.tick:
            self._restarted_at = self._looked_at
            return ""
        self._glitches += (told.glitches - last.glitches) & 0xFF
        if self._glitches > MOST_GLITCHES:
            return f"its encoders lose counts: {self._glitches} illegal steps"
        return self._state(told) or self._axis_troubles(told)

    def _state(self, told: Telemetry) -> str:
        if told.state not in SOFT:
            self._armed_by = None
            return ""
        if self.resting or (self._armed_by is not None and self._looked_at < self._armed_by):
            return ""
        faults = Fault(told.faults).name or "no fault"
        return f"the stick is soft (state {State(told.state).name}; {faults})"

    def _axis_troubles(self, told: Telemetry) -> str:
        for index, axis in enumerate(self._axes):
            position, motor = told.position[index], told.motor[index]
            stop, limit = self._expected.stops[index], self._expected.limits[index]
            if abs(position) > BEYOND_STOP * stop:
                return (
                    f"the zero of {AXES[index]} has drifted: it tells {position} counts, beyond "
                    f"its stop at {stop}"
                )
            if position != axis.position or abs(position) > AT_STOP * stop:
                axis.position, axis.since = position, told.tick
                axis.least = axis.most = motor
            elif motor < axis.least:
                axis.least = motor
            elif motor > axis.most:
                axis.most = motor
            if axis.most - axis.least > FROZEN_FORCE and told.tick - axis.since > FROZEN_TICKS:
                return (
                    f"the encoder of {AXES[index]} stands still while its force changed by "
                    f"{axis.most - axis.least} PWM steps"
                )
            if -limit < motor < limit:
                axis.free_since = told.tick
            elif told.tick - axis.free_since > SATURATED_TICKS:
                return f"the force of {AXES[index]} was at its limit for {SATURATED_TICKS} ticks"
        return ""

    def _count(self, frames: int, now: float) -> None:
        if now - self._looked_at > LONGEST_ABSENCE:
            self._whole_window = False
        self._looked_at = now
        if frames:
            self._heard_at = now
        self._frames += frames
        if self._restarted_at is not None and now - self._restarted_at > ASK_AFTER_RESTART:
            self.trouble = "the stick started anew"
        elif now - self._heard_at > SILENT_AFTER:
            self.trouble = f"nothing was heard of the stick for {SILENT_AFTER:g} s"
        elif now - self._window_from >= WINDOW:
            self._end_window(now)

    def _end_window(self, now: float) -> None:
        share = self._frames / ((now - self._window_from) * TICK_HZ)
        if self._whole_window and share < LEAST_SHARE:
            self.trouble = f"only {share:.0%} of its telemetry came"
        self._frames, self._window_from, self._whole_window = 0, now, True
