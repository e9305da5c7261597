"""How the messages of the serial protocol are packed, scaled and limited.

Written by firmware/protocol/make.py from firmware/protocol/description.yaml.
"""

from __future__ import annotations

from struct import Struct

from omnistudy.devices.stick.messages import (
    Answer,
    Arm,
    ClearFaults,
    Configuration,
    Disarm,
    Field,
    GetConfiguration,
    Hello,
    Identity,
    Ping,
    SaveConfiguration,
    SetConfiguration,
    Telemetry,
    Zero,
)

Message = (
    Hello
    | Ping
    | Arm
    | Disarm
    | Field
    | ClearFaults
    | Zero
    | GetConfiguration
    | SetConfiguration
    | SaveConfiguration
    | Identity
    | Telemetry
    | Answer
    | Configuration
)

KINDS: dict[int, type[Message]] = {
    0x01: Hello,
    0x02: Ping,
    0x03: Arm,
    0x04: Disarm,
    0x05: Field,
    0x06: ClearFaults,
    0x07: Zero,
    0x08: GetConfiguration,
    0x09: SetConfiguration,
    0x0A: SaveConfiguration,
    0x81: Identity,
    0x82: Telemetry,
    0x83: Answer,
    0x84: Configuration,
}
"""Code on the wire -> message."""

CODES = {kind: code for code, kind in KINDS.items()}
"""Message -> code on the wire."""

LAYOUTS: dict[type[Message], Struct] = {
    Hello: Struct("<"),
    Ping: Struct("<"),
    Arm: Struct("<I"),
    Disarm: Struct("<"),
    Field: Struct("<3h3h9h9hH"),
    ClearFaults: Struct("<"),
    Zero: Struct("<"),
    GetConfiguration: Struct("<"),
    SetConfiguration: Struct("<3b3b3H3h3h3h3B3B3H3HBHHHBI"),
    SaveConfiguration: Struct("<"),
    Identity: Struct("<BBII"),
    Telemetry: Struct("<I3h3h3hBBHBBBBHHH"),
    Answer: Struct("<BBB"),
    Configuration: Struct("<3b3b3H3h3h3h3B3B3H3HBHHHBI"),
}
"""How a message's payload is packed."""

COUNTS: dict[type[Message], tuple[int, ...]] = {
    Hello: (),
    Ping: (),
    Arm: (1,),
    Disarm: (),
    Field: (3, 3, 9, 9, 1),
    ClearFaults: (),
    Zero: (),
    GetConfiguration: (),
    SetConfiguration: (3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1, 1, 1, 1, 1, 1),
    SaveConfiguration: (),
    Identity: (1, 1, 1, 1),
    Telemetry: (1, 3, 3, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1),
    Answer: (1, 1, 1),
    Configuration: (3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1, 1, 1, 1, 1, 1),
}
"""How many numbers each field of a message has."""

SCALES = {
    Field: {"wrench": 32, "about": 8, "stiffness": 1024, "damping": 32},
    Telemetry: {"rate": 256},
    Configuration: {
        "counts_per_degree": 256,
        "centring_stiffness": 1024,
        "centring_damping": 32,
        "velocity_trip": 256,
        "rate_filter": 256,
    },
}
"""Message -> field -> wire steps a unit; fields that are not named have one."""

LIMITS = {
    Field: {
        "wrench": (-32736, 32736),
        "about": (-16376, 16376),
        "stiffness": (-32760, 32760),
        "damping": (-32760, 32760),
        "valid_for": (1, 250),
    },
    Configuration: {
        "motor_sign": (-1, 1),
        "encoder_sign": (-1, 1),
        "counts_per_degree": (512, 65535),
        "centring_stiffness": (0, 16383),
        "centring_damping": (0, 8191),
        "gravity": (-255, 255),
        "slew_limit": (1, 255),
        "travel": (1, 2047),
        "velocity_trip": (1, 8191),
        "rate_filter": (1, 255),
        "soft_start": (10, 10000),
        "silence": (10, 1000),
        "fade": (1, 1000),
        "glitch_limit": (1, 255),
    },
}
"""Message -> field -> least and greatest wire step that the device takes."""

DEFAULT_CONFIGURATION = Configuration(
    motor_sign=(1, 1, 1),
    encoder_sign=(1, 1, 1),
    counts_per_degree=(3072, 3840, 1024),
    centring_stiffness=(179, 179, 340),
    centring_damping=(336, 336, 370),
    gravity=(100, 70, 0),
    force_limit=(255, 255, 255),
    slew_limit=(64, 64, 64),
    travel=(360, 360, 1600),
    velocity_trip=(2560, 2560, 2560),
    rate_filter=64,
    soft_start=1000,
    silence=200,
    fade=100,
    glitch_limit=20,
    serial=0,
)
"""What a new device uses."""
