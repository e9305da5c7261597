"""A Latin square: every condition once in every place."""

from __future__ import annotations

from typing import Literal

from omnistudy.protocol.ordering.square import SquareOrder


class Latin(SquareOrder):
    """The cyclic Latin square: over as many seats as conditions each stands once in each place.

    Which condition follows which is not balanced: `williams` does that too.
    """

    kind: Literal["latin"] = "latin"

    def rows(self, size: int) -> tuple[tuple[int, ...], ...]:
        """Give `size` rows, each starting one letter later."""
        return tuple(
            tuple((first + place) % size for place in range(size)) for first in range(size)
        )
