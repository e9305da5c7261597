"""A staircase: the next condition depends on how the last ones went."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Literal

from pydantic import Field

from omnistudy.errors import nearest
from omnistudy.protocol.ordering.order import Order, PastTrial, Seat


class Staircase(Order):
    """Conditions from easy to hard, as the protocol lists them; one step a decision.

    After `harder_after` successes in a row the next condition is harder, after one failure it is
    easier (Levitt 1971, J. Acoust. Soc. Am. 49, 467-477: two down, one up converges where 71 % of
    the trials succeed).
    """

    kind: Literal["staircase"] = "staircase"
    count: Annotated[int, Field(ge=1, le=200)]
    """Trials in all."""
    start: str
    """Condition of the first trial."""
    most_collisions: Annotated[int, Field(ge=0)] = 0
    """A trial succeeds when it is completed with at most so many."""
    harder_after: Annotated[int, Field(ge=1, le=10)] = 2
    """Successes in a row."""

    def next(
        self, conditions: Sequence[str], seat: Seat, history: Sequence[PastTrial]
    ) -> str | None:
        """Go through the history step by step."""
        if len(history) >= self.count:
            return None
        level, row = conditions.index(self.start), 0
        for trial in history:
            if not self._succeeded(trial):
                level, row = max(0, level - 1), 0
            elif row + 1 == self.harder_after:
                level, row = min(len(conditions) - 1, level + 1), 0
            else:
                row += 1
        return conditions[level]

    def trials(self, conditions: Sequence[str]) -> int:
        """Give the count."""
        return self.count

    def faults(self, conditions: Sequence[str]) -> Iterator[str]:
        """Refuse a start that is no condition, and less than two conditions."""
        if self.start not in conditions:
            yield (
                f"unknown condition '{self.start}' to start with: the conditions are "
                f"{', '.join(conditions)}{nearest(self.start, conditions)}"
            )
        if len(conditions) < 2:
            yield "a staircase needs two conditions or more, from easy to hard"

    def _succeeded(self, trial: PastTrial) -> bool:
        return trial.status == "completed" and trial.collisions <= self.most_collisions
