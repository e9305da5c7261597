"""How well the parts of a live trial do, as numbers that an experimenter reads at a glance."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import inf

from omnistudy.channel import Measure
from omnistudy.channel.measure import SATURATED

REMEMBERED_S = 5.0
"""How long a late step is something to look at (ours)."""
BEHIND_S = 0.05
"""How far a trial may be behind the clock on the wall before somebody should look (ours)."""


@dataclass(frozen=True, slots=True)
class Reading:
    """One number of a part of a live trial.

    ok : False where somebody should look.
    """

    name: str
    value: float
    unit: str
    ok: bool


DEVICE_LIMITS: Mapping[str, float] = {
    "turn_lateness_p99": 0.005,
    "dropped_frames": 0.0,
    "damaged_frames": 0.0,
    "late_fields": 0.0,
}
"""Greatest value of a device's measures at which nobody need look (ours)."""
SATURATED_SHARE = 0.2
"""Share of its ticks that an axis may push with all it has before somebody should look (ours)."""


def device_health(measures: Iterable[Measure]) -> tuple[Reading, ...]:
    """Give what an experimenter should know of the device among what it tells of a trial."""
    return tuple(_judged(*told) for told in measures if _limit(told.name) is not None)


def _limit(name: str) -> float | None:
    return SATURATED_SHARE if name.startswith(SATURATED) else DEVICE_LIMITS.get(name)


def _judged(name: str, value: float, unit: str) -> Reading:
    ok = value <= (_limit(name) or 0.0)
    words = name.replace("_", " ")
    if unit == "s":
        return Reading(words, 1000.0 * value, "ms", ok)
    return Reading(words, value, "", ok)


class LoopHealth:
    """Follows how the loop of one trial keeps pace."""

    def __init__(self) -> None:
        self._late = 0
        self._late_at = -inf

    def readings(self, t: float, late: int, behind: float) -> tuple[Reading, ...]:
        """Give what there is to say at t s of the trial.

        late : late steps so far. behind : s that the trial is behind the clock on the wall.
        """
        if late > self._late:
            self._late, self._late_at = late, t
        return (
            Reading("late steps", late, "", t - self._late_at > REMEMBERED_S),
            Reading("behind the clock", max(0.0, 1000.0 * behind), "ms", behind <= BEHIND_S),
        )
