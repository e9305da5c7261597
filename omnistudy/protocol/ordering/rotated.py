"""A cyclic Latin square: every condition once, each slot starting one further."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from omnistudy.protocol.ordering.order import Order


class Rotated(Order):
    """Every condition once, in the order of the protocol, each slot starting one condition later.

    Over as many slots as conditions every condition stands once in every place; which condition
    precedes which is not balanced.
    """

    kind: Literal["rotated"] = "rotated"

    def sequence(
        self, conditions: Sequence[str], slot: int, rng: np.random.Generator
    ) -> tuple[str, ...]:
        """Give the conditions from this slot's first on; draws nothing."""
        first = slot % len(conditions)
        return (*conditions[first:], *conditions[:first])
