"""What orders from a square of rows share: its rows are dealt out in shuffled blocks."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from typing import Annotated

from pydantic import Field

from omnistudy.protocol.ordering.counts import place_counts, spread
from omnistudy.protocol.ordering.order import PlannedOrder, Seat


class SquareOrder(PlannedOrder):
    """Rows of a square of conditions.

    Which condition takes which letter of the square is drawn once; then every run of as many seats
    as the square has rows meets each row once, in an order that is drawn anew for each run.
    """

    block_length: Annotated[int, Field(ge=1, le=100)] = 1
    """Trials in succession in each place of the row."""
    repetitions: Annotated[int, Field(ge=1, le=100)] = 1
    """How often the row is gone through."""

    @abstractmethod
    def rows(self, size: int) -> tuple[tuple[int, ...], ...]:
        """Give the rows of the square for `size` conditions, letters counted from 0."""

    def sequence(self, conditions: Sequence[str], seat: Seat) -> tuple[str, ...]:
        """Give the seat's row."""
        rows = self.rows(len(conditions))
        run, place = divmod(seat.row, len(rows))
        dealt = seat.shared(f"rows of run {run}").permutation(len(rows))
        names = [conditions[letter] for letter in seat.shared("letters").permutation(len(rows[0]))]
        once = [names[letter] for letter in rows[dealt[place]] for _ in range(self.block_length)]
        return tuple(once * self.repetitions)

    def period(self, conditions: Sequence[str]) -> int:
        """Every row once."""
        return len(self.rows(len(conditions)))

    def imbalance(
        self, conditions: Sequence[str], sequences: Sequence[Sequence[str]]
    ) -> tuple[str, ...]:
        """Say when some condition stands in some place more often than another."""
        once = self._first_pass(conditions, sequences)
        least, most = spread(place_counts(conditions, once, self.block_length).values())
        if least == most:
            return ()
        return (f"a condition stands {least} to {most} times in a place",)

    def faults(self, conditions: Sequence[str]) -> Iterator[str]:
        """Refuse a single condition, which has no order."""
        if len(conditions) < 2:
            yield (
                f"'{self.kind}' cannot balance a single condition ({', '.join(conditions)}): give "
                "it two or more, or take permuted_blocks"
            )

    def _first_pass(
        self, conditions: Sequence[str], sequences: Sequence[Sequence[str]]
    ) -> list[Sequence[str]]:
        return [sequence[: len(conditions) * self.block_length] for sequence in sequences]
