"""Which attempts count, and what became of the others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd

RAN = ("completed", "timed_out")
"""Statuses whose collisions are counted: leaving out those who ran out of time would flatter."""
STATUSES = ("planned", "running", "completed", "timed_out", "void", "aborted")


@dataclass(frozen=True, slots=True)
class ConditionCount:
    """Attempts of one condition by status, in the order of STATUSES."""

    condition: str
    attempts: tuple[int, ...]

    def of(self, status: str) -> int:
        """Give the number of attempts with a status."""
        return self.attempts[STATUSES.index(status)]


def counted(trials: pd.DataFrame) -> pd.DataFrame:
    """Give the attempts that count: of each planned trial the last one that ran."""
    ran = trials[trials["status"].isin(RAN)]
    places = ["participant", "visit", "position"]
    return ran.sort_values([*places, "attempt"]).drop_duplicates(places, keep="last")


def completed(trials: pd.DataFrame) -> pd.DataFrame:
    """Give those of the attempts that reached the finish: only they have a completion time."""
    return trials[trials["status"] == "completed"]


def count_attempts(trials: pd.DataFrame, conditions: Sequence[str]) -> tuple[ConditionCount, ...]:
    """Count every attempt by condition and status."""
    found = trials.groupby(["condition", "status"], observed=True).size().to_dict()
    return tuple(
        ConditionCount(
            condition, tuple(int(found.get((condition, status), 0)) for status in STATUSES)
        )
        for condition in conditions
    )
