"""The trial labels of Tyagi 2017: names of conditions and repetitions, not the order in time."""

from __future__ import annotations

from collections.abc import Collection

from omnistudy.analysis.outcomes import Place

WITH = "full"
WITHOUT = "none"
CONDITIONS = (WITH, WITHOUT, "centre_front_10", "centre_front_20", "centre_rear_10", "zero_torque")
"""The six conditions of the second study (sec. 4.5), in the order of their labels."""

LABELS = (
    *(Place(f"T{n}", WITH, n) for n in (1, 2, 3)),
    *(Place(f"T{n + 3}", WITHOUT, n) for n in (1, 2, 3)),
    Place("T7", "centre_front_10", 1),
    Place("T8", "centre_front_20", 1),
    Place("T9", "centre_rear_10", 1),
    Place("T10", "zero_torque", 1),
)
"""T1-T3 with feedback, T4-T6 without, T7-T9 centre moved, T10 zero torque (sec. 5.1, p. 50)."""

AVERAGES = (
    Place("Tavg with", WITH, average=True),
    Place("Tavg without", WITHOUT, average=True),
)
"""Means over all trials with and without feedback (sec. 5.1); we read "with" as T1-T3."""


def is_utah2017(conditions: Collection[str]) -> bool:
    """Tell whether a study has the six conditions of the thesis and no other."""
    return set(conditions) == set(CONDITIONS)
