"""The order of the published study: blocks that alternate between people, then a fixed tail."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from omnistudy.protocol.ordering.order import Order


class PublishedBlocks(Order):
    """Blocks of one condition each, rotated from slot to slot, then the same last trials for all.

    Tyagi 2017, sec. 5.1. Only the blocks are counterbalanced: the last trials always come
    last in one order, so their conditions are confounded with practice.
    """

    kind: Literal["published_blocks"] = "published_blocks"
    blocks: Annotated[tuple[str, ...], Field(min_length=1)]
    """Conditions of the blocks for slot 0; every further slot starts one block later."""
    block_length: Annotated[int, Field(ge=1, le=100)] = 3
    """Trials in each block (Tyagi 2017, sec. 4.5: three)."""
    last: tuple[str, ...] = ()
    """Conditions of the trials after the blocks, the same for every slot."""

    def sequence(
        self, conditions: Sequence[str], slot: int, rng: np.random.Generator
    ) -> tuple[str, ...]:
        """Give the blocks from this slot's first on, then the last trials; draws nothing."""
        first = slot % len(self.blocks)
        blocks = self.blocks[first:] + self.blocks[:first]
        return tuple(name for name in blocks for _ in range(self.block_length)) + self.last
