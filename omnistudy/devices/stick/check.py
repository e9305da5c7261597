"""Looks a stick over before it is used: who it is, what its line carries, what forbids force."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.devices.stick.layouts import DEFAULT_CONFIGURATION
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import CYCLES_PER_TICK, TICK_HZ, Fault, Sign, State
from omnistudy.errors.devices import NoTelemetry

START_WITHIN = 4.0
"""s: a stock Mega's bootloader waits for up to two before it starts the firmware (ours)."""
LATCHING = 0x00FF
"""The faults that forbid force."""


class Finding(NamedTuple):
    """One thing looked at."""

    what: str
    found: str
    sound: bool


def wait_for_telemetry(line: StickLine) -> None:
    """Wait until the stick has started; raises NoTelemetry."""
    end = line.transport.now() + START_WITHIN
    while line.transport.now() < end:
        if line.listen(0.1):
            return
    raise NoTelemetry(START_WITHIN)


def check_stick(line: StickLine, seconds: float = 1.0) -> tuple[Finding, ...]:
    """Give what is found; never turns force on. Raises NoTelemetry, NoAnswer, WrongProtocol."""
    wait_for_telemetry(line)
    identity = line.identify()
    settings = line.configuration()
    line.listen(0.05)
    before = line.deframer.damaged
    heard = line.listen(seconds)
    damaged = line.deframer.damaged - before
    if not heard:
        raise NoTelemetry(seconds)
    last = heard[-1]
    ticks = last.tick - heard[0].tick + 1
    lost = ticks - len(heard)
    faults = Fault(last.faults)
    worked = max(one.worked for one in heard) / CYCLES_PER_TICK
    return (
        Finding("firmware", f"{identity.firmware:08x}", True),
        Finding("serial number", str(identity.serial), True),
        Finding(
            "settings",
            "defaults" if settings == DEFAULT_CONFIGURATION else "its own",
            not faults & Fault.DEFAULTS,
        ),
        Finding("telemetry", f"{ticks} ticks, {lost} lost", lost <= ticks // TICK_HZ),
        Finding("damaged frames", str(damaged), damaged == 0),
        Finding("ticks missed", str(last.missed), last.missed == 0),
        Finding("share of a tick to drive the motors", f"{worked:.0%}", worked < 0.5),
        Finding("state", State(last.state).name, last.state == State.IDLE),
        Finding("faults", faults.name or "none", not last.faults & LATCHING),
        Finding(
            "emergency stop",
            "pressed, or its wire broken" if last.signs & Sign.STOPPED else "released",
            not last.signs & Sign.STOPPED,
        ),
        Finding("dead-man's switch", "held" if last.signs & Sign.HELD else "not held", True),
        Finding("position", f"{last.position} counts", True),
    )
