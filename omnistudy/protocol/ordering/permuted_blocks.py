"""Permuted blocks: every condition once a block, each block shuffled anew."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

from pydantic import Field

from omnistudy.protocol.ordering.order import PlannedOrder, Seat


class PermutedBlocks(PlannedOrder):
    """Blocks in which every condition stands once, in an order drawn for each participant.

    Practice is spread over the conditions block by block for each participant alone; places and
    what follows what are even only on the average.
    """

    kind: Literal["permuted_blocks"] = "permuted_blocks"
    blocks: Annotated[int, Field(ge=1, le=100)] = 1
    """How often every condition is met."""

    def sequence(self, conditions: Sequence[str], seat: Seat) -> tuple[str, ...]:
        """Draw every block."""
        rng = seat.own("blocks")
        drawn = [rng.permutation(len(conditions)) for _ in range(self.blocks)]
        return tuple(conditions[index] for block in drawn for index in block)
