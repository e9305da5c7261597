"""What must pass before a stick gets force: switches, enable line, signs, zero, centring.

Works on any transport; a stick under these checks has two fifths of its force at most.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from omnistudy.channel import Measure
from omnistudy.devices.stick.check import LATCHING, Finding, wait_for_telemetry
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import (
    Configuration,
    Identity,
    Ping,
    Sign,
    State,
    Telemetry,
    Three,
)
from omnistudy.devices.stick.motions import (
    SOFT_START,
    go_to,
    heard_now,
    limited,
    low_force,
    moved_by_a_push,
    rest_after_a_push,
    stops_of,
)
from omnistudy.devices.stick.watch import AXES
from omnistudy.errors.devices import NoTelemetry, Refused
from omnistudy.errors.stick_checks import ChecksFailed, ForceGone

HOLD_SWITCH = "Release the emergency stop and hold the dead-man's switch."
PRESS_STOP = "Press the emergency stop."
RELEASE_STOP = "Release the emergency stop."
LEAVE_SWITCH = "Let go of the dead-man's switch."
LET_GO = "Hold the dead-man's switch, but not the handle: the stick moves to its stops by itself."
PATIENCE = 60.0
"""s that somebody may take for one of them (ours)."""
LOOK = 0.02
"""s between two looks, each of which shows the stick that the host lives (ours)."""
LEAST_MOVE = 5
"""Counts that a push must move an axis by (ours)."""
TRAVEL_TOLERANCE = 0.1
"""Of the travel that is said of the stick, by which that found may differ (ours)."""
ZERO_TOLERANCE = 10
"""Counts: 1.4 mm. A zero further off makes what was driven since the last checks doubtful
(ours)."""
CENTRE_TOLERANCE = 40
"""Counts within which a stick that is let go comes to rest: it must not drive, and its dead zone
ends at 42 counts of theta, 67 of x and y (Tyagi 2017, App. B; static friction is ours)."""


class Checks(NamedTuple):
    """What was found before force, and of which stick.

    shifts : counts by which the zero of each axis was off before it was set anew; 0: it was not.
    """

    identity: Identity
    findings: tuple[Finding, ...]
    shifts: Three = (0, 0, 0)

    @property
    def passed(self) -> bool:
        """Whether there may be force."""
        return all(finding.sound for finding in self.findings)

    @property
    def drifted(self) -> bool:
        """Whether what was driven since the last checks is in doubt."""
        return any(abs(shift) > ZERO_TOLERANCE for shift in self.shifts)


def findings(checks: Checks) -> tuple[Measure, ...]:
    """Give what was found as numbers to be stored: 1 passed, 0 failed, and counts of drift."""
    outcomes = [
        Measure(f"check_{_as_name(one.what)}", float(one.sound), "1") for one in checks.findings
    ]
    drift = [
        Measure(f"zero_shift_{axis}", float(shift), "count")
        for axis, shift in zip(AXES, checks.shifts, strict=True)
    ]
    return (*outcomes, *drift)


def _as_name(words: str) -> str:
    return words.replace("'s", "").replace("-", "_").replace(" ", "_")


def insist(checks: Checks) -> Checks:
    """Give the checks back; raises ChecksFailed unless they passed."""
    failed = [f"{one.what}: {one.found}" for one in checks.findings if not one.sound]
    if failed:
        raise ChecksFailed(failed)
    return checks


def check_before_force(
    line: StickLine,
    stops: Three,
    tell: Callable[[str], None],
    expected: Identity | None = None,
    patience: float = PATIENCE,
) -> Checks:
    """Lead through all checks and give what was found; after one that fails no other is tried.

    stops : mechanical stops, counts either way. tell : shows a sentence to whoever is at the stick.
    expected : who the stick was before; another one fails. patience : s for each switch.
    Raises NoTelemetry, NoAnswer, WrongProtocol.
    """
    wait_for_telemetry(line)
    identity = line.identify()
    settings = line.configuration()
    leading = _Leading(line, settings, stops, tell, patience)
    try:
        leading.lead(identity, expected)
    except (ForceGone, NoTelemetry, Refused) as cause:
        leading.note("force", str(cause), False)
    line.disarm()
    line.configure(settings)
    return Checks(identity, tuple(leading.findings), leading.shifts)


class _Leading:
    """One leading through the checks."""

    def __init__(
        self,
        line: StickLine,
        settings: Configuration,
        stops: Three,
        tell: Callable[[str], None],
        patience: float,
    ) -> None:
        self._line = line
        self._settings = settings
        self._stops = stops
        self._tell = tell
        self._patience = patience
        self.findings: list[Finding] = []
        self.shifts: Three = (0, 0, 0)

    def note(self, what: str, found: str, sound: bool) -> bool:
        self.findings.append(Finding(what, found, sound))
        return sound

    def lead(self, identity: Identity, expected: Identity | None) -> None:
        if not (self._same(identity, expected) and self._ready() and self._switches()):
            return
        self._tell(LET_GO)
        with low_force(self._line, self._settings):
            sound = self._signs() and self._zeros()
        if sound:
            self._line.zero()
            self._centring()

    def _same(self, identity: Identity, expected: Identity | None) -> bool:
        found = f"serial number {identity.serial}, firmware {identity.firmware:08x}"
        same = expected is None or identity[2:] == expected[2:]
        if expected is not None and not same:
            found += f" instead of {expected.serial}, {expected.firmware:08x}"
        return self.note("same stick", found, same)

    def _ready(self) -> bool:
        self._tell(HOLD_SWITCH)
        wanted = Sign.HELD | Sign.STOPPED
        held = self._sees(lambda told: told.signs & wanted == Sign.HELD)
        if not held:
            return self.note("dead-man's switch held", "nobody held it, or it is stopped", False)
        self._clear()
        self._arm()
        on = self._sees(lambda told: bool(told.signs & Sign.ENABLED), 1.0)
        return self.note("enable line on with force", "high" if on else "stays low", on)

    def _switches(self) -> bool:
        """Take the force away by each switch; give whether each did so and was felt."""
        return (
            self._acts("emergency stop pressed", PRESS_STOP, Sign.STOPPED, True, State.FAULT)
            and self._acts("emergency stop released", RELEASE_STOP, Sign.STOPPED, False, None)
            and self._force_again()
            and self._acts("dead-man's switch let go", LEAVE_SWITCH, Sign.HELD, False, State.IDLE)
            and self._acts("dead-man's switch held", HOLD_SWITCH, Sign.HELD, True, None)
        )

    def _acts(self, what: str, sentence: str, sign: Sign, on: bool, then: State | None) -> bool:
        self._tell(sentence)
        if not self._sees(lambda told: bool(told.signs & sign) == on):
            return self.note(what, f"not noticed within {self._patience:g} s", False)
        last = heard_now(self._line, LOOK)[-1]
        if then is not None and (last.state != then or last.signs & Sign.ENABLED):
            return self.note(what, "noticed, but force and enable line stay on", False)
        return self.note(what, "noticed" + (", and force went" if then is not None else ""), True)

    def _force_again(self) -> bool:
        self._clear()
        self._arm()
        return True

    def _signs(self) -> bool:
        signs = [self._sign(axis) for axis in range(3)]
        return all(signs)

    def _sign(self, axis: int) -> bool:
        moved = moved_by_a_push(self._line, axis)
        if abs(moved) < LEAST_MOVE:
            found = "did not move: dead motor, frozen encoder, or somebody holds it"
        elif moved < 0:
            found = "moved the wrong way: motor or encoder is inverted"
        else:
            found = "moved the right way"
        return self.note(f"sign of {AXES[axis]}", found, moved >= LEAST_MOVE)

    def _zeros(self) -> bool:
        """Find each zero between its stops and leave the stick there."""
        found = [stops_of(self._line, axis) for axis in range(3)]
        x, y, theta = (stops.middle for stops in found)
        self.shifts = (x, y, theta)
        for axis, stops in enumerate(found):
            said = self._stops[axis]
            near = abs(stops.travel - said) <= TRAVEL_TOLERANCE * said
            self.note(
                f"travel of {AXES[axis]}", f"{stops.travel} counts of {said} either way", near
            )
            off = abs(stops.middle) > ZERO_TOLERANCE
            told = f"{stops.middle} counts off{', set anew' if off else ''}"
            self.note(f"zero of {AXES[axis]}", told, True)
        there = go_to(self._line, self.shifts)
        away = max(abs(a - b) for a, b in zip(there, self.shifts, strict=True))
        self.note("middle reached", f"to {away} counts", away <= ZERO_TOLERANCE)
        return all(finding.sound for finding in self.findings)

    def _centring(self) -> None:
        """Let the stick stand by its own centring, with little force."""
        little = limited(self._settings)
        self._line.configure(self._settings._replace(force_limit=little, soft_start=SOFT_START))
        self._line.arm()
        rest = rest_after_a_push(self._line)
        for axis, counts in enumerate(rest):
            self.note(f"rest of {AXES[axis]}", f"{counts} counts", abs(counts) <= CENTRE_TOLERANCE)

    def _clear(self) -> None:
        if heard_now(self._line, LOOK)[-1].faults & LATCHING:
            self._line.clear_faults()

    def _arm(self) -> None:
        """Arm without any field or centring: motors and amplifiers are on, but push nothing."""
        none: Three = (0, 0, 0)
        self._line.disarm()
        self._line.configure(
            self._settings._replace(
                centring_stiffness=none, centring_damping=none, gravity=none, soft_start=10
            )
        )
        self._line.arm()

    def _sees(self, until: Callable[[Telemetry], bool], patience: float | None = None) -> bool:
        line = self._line
        end = line.transport.now() + (self._patience if patience is None else patience)
        while line.transport.now() < end:
            line.send(Ping())
            if any(until(told) for told in line.listen(LOOK)):
                return True
        return False
