"""How well the parts of a live trial do, as numbers that an experimenter reads at a glance."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

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
