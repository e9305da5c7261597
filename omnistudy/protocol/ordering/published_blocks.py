"""The order of the published study: blocks that alternate between people, then a fixed tail."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Annotated, Literal

from pydantic import Field

from omnistudy.errors import nearest
from omnistudy.protocol.ordering.counts import spread
from omnistudy.protocol.ordering.order import PlannedOrder, Seat


class PublishedBlocks(PlannedOrder):
    """Blocks of one condition each, rotated from seat to seat, then the same last trials for all.

    Tyagi 2017, sec. 5.1. Only the blocks are counterbalanced: the last trials always come
    last in one order, so their conditions are confounded with practice.
    """

    kind: Literal["published_blocks"] = "published_blocks"
    blocks: Annotated[tuple[str, ...], Field(min_length=1)]
    """Conditions of the blocks for the first seat; every further one starts one block later."""
    block_length: Annotated[int, Field(ge=1, le=100)] = 3
    """Trials in each block (Tyagi 2017, sec. 4.5: three)."""
    last: tuple[str, ...] = ()
    """Conditions of the trials after the blocks, the same for every seat."""

    def sequence(self, conditions: Sequence[str], seat: Seat) -> tuple[str, ...]:
        """Give the blocks from this seat's first on, then the last trials; draws nothing."""
        first = seat.row % len(self.blocks)
        blocks = self.blocks[first:] + self.blocks[:first]
        return tuple(name for name in blocks for _ in range(self.block_length)) + self.last

    def period(self, conditions: Sequence[str]) -> int:
        """Every block once in front."""
        return len(self.blocks)

    def imbalance(
        self, conditions: Sequence[str], sequences: Sequence[Sequence[str]]
    ) -> tuple[str, ...]:
        """Say when some block comes first more often than another."""
        firsts = Counter(dict.fromkeys(self.blocks, 0))
        firsts.update(sequence[0] for sequence in sequences)
        least, most = spread(firsts.values())
        return (f"a block comes first {least} to {most} times",) if least < most else ()

    def faults(self, conditions: Sequence[str]) -> Iterator[str]:
        """Refuse names that are no conditions."""
        for given in dict.fromkeys((*self.blocks, *self.last)):
            if given not in conditions:
                yield (
                    f"unknown condition '{given}': the conditions are {', '.join(conditions)}"
                    f"{nearest(given, conditions)}"
                )
