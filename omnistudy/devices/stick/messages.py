"""The messages of the joystick's serial protocol, in wire steps.

Written by firmware/protocol/make.py from firmware/protocol/description.yaml.
"""

from __future__ import annotations

from enum import IntEnum, IntFlag
from typing import NamedTuple

Three = tuple[int, int, int]
Nine = tuple[int, int, int, int, int, int, int, int, int]

PROTOCOL_VERSION = 1
BAUD = 500000
TICK_HZ = 1000
LONGEST_PAYLOAD = 96
ARM_KEY = 1179603523
"""What `arm` must carry, so that no stray frame gives force."""
FULL_DUTY = 255
"""PWM steps of a motor at full duty."""
CYCLES_PER_TICK = 16000
"""Processor cycles in one tick."""


class State(IntEnum):
    """What the motors may do."""

    IDLE = 0
    """Motors and amplifiers off, waiting for `arm`."""
    RISING = 1
    """Soft start: the force grows from nothing."""
    FORCE = 2
    """All force that the limits allow."""
    FADING = 3
    """The host is silent: the force shrinks to nothing, then IDLE."""
    FAULT = 4
    """Motors and amplifiers off until `clear_faults`."""


class Outcome(IntEnum):
    """What became of a request."""

    DONE = 0
    """Done."""
    UNKNOWN = 1
    """No such message, or its length is wrong."""
    ILLEGAL = 2
    """A value is outside its limits."""
    NOT_NOW = 3
    """Not in this state: disarm first, or an EEPROM write is under way."""
    WRONG_KEY = 4
    """`arm` without its key."""
    ESTOP = 5
    """The emergency stop is pressed or its wire is broken."""
    DEAD_MAN = 6
    """Nobody holds the dead-man's switch."""
    FAULTY = 7
    """A fault is latched: `clear_faults` first."""
    MOVING = 8
    """The stick moves too fast or stands beyond its travel."""


class Fault(IntFlag):
    """What went wrong; the first byte latches and turns the force off, the second only tells."""

    ESTOP = 0x1
    """Emergency stop pressed, or its wire broken."""
    VELOCITY = 0x2
    """An axis was faster than its `velocity_trip`."""
    TRAVEL = 0x4
    """An axis went beyond its `travel`: slipped, or counts lost."""
    ENCODER = 0x8
    """More than `glitch_limit` illegal encoder steps within a second."""
    WATCHDOG = 0x10
    """The program hung and was started anew."""
    OVERRUN = 0x20
    """Ten ticks missed within a second."""
    DEAD_MAN = 0x100
    """The dead-man's switch was let go; cleared by `arm`."""
    SILENT = 0x200
    """No sound frame came for `silence`; cleared by `arm`."""
    DEFAULTS = 0x400
    """No sound configuration in EEPROM: defaults are in use."""


class Sign(IntFlag):
    """What the device sees and does at this tick."""

    SATURATED_X = 0x1
    """Force in x clipped by its limit."""
    SATURATED_Y = 0x2
    """Force in y clipped by its limit."""
    SATURATED_THETA = 0x4
    """Torque clipped by its limit."""
    SLEWING = 0x8
    """A force is held back by its slew limit."""
    FIELD = 0x10
    """A field is in force; off when none came or it is stale."""
    ENABLED = 0x20
    """The amplifiers' enable line is high."""
    HELD = 0x40
    """The dead-man's switch is held."""
    STOPPED = 0x80
    """The emergency stop is pressed."""


class Hello(NamedTuple):
    """Ask who is there; the device answers with `identity`."""


class Ping(NamedTuple):
    """Show that the host lives; a field does it as well. Not answered."""


class Arm(NamedTuple):
    """Begin the soft start. Forgets the last field and takes any sequence number next."""

    key: int
    """ARM_KEY."""


class Disarm(NamedTuple):
    """Turn motors and amplifiers off at once."""


class Field(NamedTuple):
    """The local force field, F = wrench - stiffness·(q - about) - damping·rate.

    Axes are (x, y, theta), matrices stand row by row. Its sequence number must lie 1 to 127
    ahead of the last one taken: a repeated or older frame is refused and renews nothing.
    Not answered; telemetry names the last one taken.
    """

    wrench: Three
    """Force where the stick is at `about`; 32 steps a PWM."""
    about: Three
    """Where `wrench` holds; 8 steps a count."""
    stiffness: Nine
    """Rows are forces, columns positions; 1024 steps a PWM/count."""
    damping: Nine
    """Rows are forces, columns rates; 32 steps a PWM·ms/count."""
    valid_for: int
    """From arrival; then the force fades over as long again; ms."""


class ClearFaults(NamedTuple):
    """Unlatch the faults whose cause is gone; from FAULT to IDLE."""


class Zero(NamedTuple):
    """The stick is in its centre now; only in IDLE or FAULT."""


class GetConfiguration(NamedTuple):
    """Ask for `configuration`."""


class SaveConfiguration(NamedTuple):
    """Write the settings in use to EEPROM; answered when the last byte is written.

    Only in IDLE or FAULT.
    """


class Identity(NamedTuple):
    """Who this is, and why it last started."""

    version: int
    """Of this protocol."""
    reset_cause: int
    """MCUSR: 1 power, 2 reset pin, 4 brown-out, 8 watchdog."""
    firmware: int
    """The first 32 bits of the SHA-256 of the firmware's sources."""
    serial: int
    """The device's serial number, from its configuration."""


class Telemetry(NamedTuple):
    """What the device saw and did, every tick."""

    tick: int
    """Ticks since the start; the time of the sample; ms."""
    position: Three
    """Encoders, with their signs; count."""
    rate: Three
    """Filtered; 256 steps a count/ms."""
    motor: Three
    """Commanded after all limits, before the motors' signs; PWM."""
    state: int
    """State."""
    signs: int
    """Sign."""
    faults: int
    """Fault."""
    field: int
    """Sequence number of the last field taken."""
    refused: int
    """Frames refused so far, modulo 256."""
    glitches: int
    """Illegal encoder steps so far, modulo 256."""
    missed: int
    """Ticks missed so far, modulo 256."""
    late: int
    """From the tick's moment to the reading of the encoders; cycle."""
    worked: int
    """From the tick's moment to the driving of the motors; cycle."""
    busy: int
    """From the last tick's moment to the end of its work, telemetry included; cycle."""


class Answer(NamedTuple):
    """What became of a request."""

    request: int
    """Code of the request."""
    sequence: int
    """Sequence number of the request."""
    outcome: int
    """Outcome."""


class Configuration(NamedTuple):
    """The settings in use."""

    motor_sign: Three
    """-1 turns a motor round; 0: no motor."""
    encoder_sign: Three
    """-1 turns an encoder round; 0: no encoder."""
    counts_per_degree: Three
    """Of the handle; 12, 15, 4 (Tyagi 2017, App. B); 256 steps a count/degree."""
    centring_stiffness: Three
    """0.7 PWM/degree of the motor, theta 1.9 times that (Tyagi 2017, App.

    B); 1024 steps a PWM/count.
    """
    centring_damping: Three
    """42 PWM·ms/degree of the motor, theta 1.1 times that (Tyagi 2017, App.

    B); 32 steps a PWM·ms/count.
    """
    gravity: Three
    """The handle's weight, times the sine of its angle (Tyagi 2017, eq. 2.1); PWM."""
    force_limit: Three
    """No motor gets more; PWM."""
    slew_limit: Three
    """No motor changes faster, but for turning off (ours); PWM/ms."""
    travel: Three
    """Beyond it is a fault; the stops are at 300, 300, 1440 (ours); count."""
    velocity_trip: Three
    """Faster is a fault (ours); 256 steps a count/ms."""
    rate_filter: int
    """Share of the new difference in the filtered rate (ours); 256 steps a 1."""
    soft_start: int
    """From no force to all (ours); ms."""
    silence: int
    """Without a sound frame until the force fades (ours); ms."""
    fade: int
    """From all force to none (ours); ms."""
    glitch_limit: int
    """Illegal encoder steps in a second that are a fault (ours)."""
    serial: int
    """The device's serial number."""


class SetConfiguration(Configuration):
    """Use these settings until the next reset; only in IDLE or FAULT."""

    __slots__ = ()
