"""Numbers about how an attempt was run, not about what happened in it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

MEASURES: Mapping[str, str] = {
    "late_steps": "1",
    "device_turns": "1",
    "late_turns": "1",
    "turn_lateness_p50": "s",
    "turn_lateness_p99": "s",
    "turn_lateness_max": "s",
    "device_ticks": "1",
    "dropped_frames": "1",
    "damaged_frames": "1",
    "late_fields": "1",
    "recorded_rows": "1",
    "lost_rows": "1",
    "display_frames": "1",
    "display_lag_p50": "s",
    "display_lag_p99": "s",
}
"""Unit of every measure; docs/database.md says what each means."""
SATURATED = "saturated_"
"""Before the name of an axis: share of the device's ticks at which it pushed with all it has, 1."""
CHECKED = ("check_", "zero_shift_")
"""Before the name of what was checked before force: 1 passed; counts by which a zero was off."""


class Measure(NamedTuple):
    """One number of an attempt, such as how late its steps were: name, value, SI unit."""

    name: str
    value: float
    unit: str


def measured(name: str, value: float) -> Measure:
    """Give a measure with its unit; raises KeyError for a name that is none."""
    return Measure(name, float(value), "1" if name.startswith(SATURATED) else MEASURES[name])


def is_measure(name: str) -> bool:
    """Tell whether an attempt can have a measure of this name."""
    begins = (SATURATED, *CHECKED)
    return name in MEASURES or (name.startswith(begins) and name not in begins)
