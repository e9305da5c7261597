"""What happened, counted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd

from omnistudy.analysis.counting import counted


@dataclass(frozen=True, slots=True)
class EventCount:
    """Events of one kind, by condition in the order asked for, in the trials that ran."""

    kind: str
    by_condition: tuple[int, ...]

    @property
    def total(self) -> int:
        """Give the number over all conditions."""
        return sum(self.by_condition)


def count_events(
    trials: pd.DataFrame, events: pd.DataFrame, conditions: Sequence[str]
) -> tuple[EventCount, ...]:
    """Count every kind of event by condition."""
    ran = counted(trials)[["trial", "condition"]]
    known = events.merge(ran, on="trial")
    found = known.groupby(["kind", "condition"], observed=True).size().to_dict()
    return tuple(
        EventCount(str(kind), tuple(int(found.get((kind, name), 0)) for name in conditions))
        for kind in sorted(known["kind"].unique())
    )
