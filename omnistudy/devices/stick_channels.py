"""What a stick with our firmware records at every tick, besides where it is."""

from __future__ import annotations

from collections.abc import Sequence

from omnistudy.channel import Channel
from omnistudy.devices.stick.messages import CYCLES_PER_TICK, Telemetry

CHANNELS = (
    Channel("motor_x", "N", "commanded motor force after clipping, with centring"),
    Channel("motor_y", "N", "commanded motor force after clipping, with centring"),
    Channel("motor_theta", "N·m", "commanded torque after clipping, with centring"),
    Channel("stick_worked", "1", "share of a tick until the motors were driven"),
    Channel("stick_missed", "1", "ticks that the firmware missed so far"),
    Channel("stick_tick", "ms", "the stick's own time"),
    Channel("stick_state", "1", "state of the firmware, docs/joystick-protocol.md"),
    Channel("stick_signs", "1", "saturation, enable line, switches, as bits"),
    Channel("stick_faults", "1", "faults of the firmware, as bits"),
    Channel("energy_x", "J", "taken from the hand in this trial; below zero: given to it"),
    Channel("energy_y", "J", "taken from the hand in this trial; below zero: given to it"),
    Channel("energy_theta", "J", "taken from the hand in this trial; below zero: given to it"),
)
WORKED = 3
"""Place of `stick_worked`."""


def axes(per_count: tuple[float, float, float]) -> tuple[Channel, Channel, Channel]:
    """Describe the axes; per_count in m, m, rad is their resolution."""
    x, y, theta = per_count
    return (
        Channel("stick_x", "m", "handle's travel, forward", x),
        Channel("stick_y", "m", "handle's travel, left", y),
        Channel("stick_theta", "rad", "handle's twist, counter-clockwise", theta),
    )


def values(told: Telemetry, force: Sequence[float], energy: Sequence[float]) -> tuple[float, ...]:
    """Give a tick's values in the order of CHANNELS; force in N, N, N·m, energy in J."""
    return (
        *force,
        told.worked / CYCLES_PER_TICK,
        float(told.missed),
        float(told.tick),
        float(told.state),
        float(told.signs),
        float(told.faults),
        *energy,
    )
