"""Williams's square: every condition once in every place, and after every other equally often."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from omnistudy.protocol.ordering.counts import neighbour_counts, spread
from omnistudy.protocol.ordering.square import SquareOrder


class Williams(SquareOrder):
    """A Latin square in which each condition follows each other one equally often.

    Williams (1949), Australian Journal of Scientific Research A2, 149-168. An even number of
    conditions needs one square, an odd number two, the second being the first read backwards.
    """

    kind: Literal["williams"] = "williams"

    def rows(self, size: int) -> tuple[tuple[int, ...], ...]:
        """Give `size` rows for an even size, twice as many for an odd one."""
        first = [(place + 1) // 2 if place % 2 else -(place // 2) for place in range(size)]
        square = tuple(tuple((letter + shift) % size for letter in first) for shift in range(size))
        return square if size % 2 == 0 else square + tuple(row[::-1] for row in square)

    def imbalance(
        self, conditions: Sequence[str], sequences: Sequence[Sequence[str]]
    ) -> tuple[str, ...]:
        """Say when places are uneven, and when some condition follows some other more often."""
        once = self._first_pass(conditions, sequences)
        least, most = spread(neighbour_counts(conditions, once).values())
        carried = (f"a condition follows another {least} to {most} times",) if least < most else ()
        return super().imbalance(conditions, sequences) + carried
