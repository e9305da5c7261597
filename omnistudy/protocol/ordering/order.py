"""What every order can do: give the conditions of a slot in time."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

import numpy as np

from omnistudy.registry import KindModel


class Order(KindModel, ABC):
    """Parameters of an order; pure, it depends on the slot and the slot's generator alone."""

    @abstractmethod
    def sequence(
        self, conditions: Sequence[str], slot: int, rng: np.random.Generator
    ) -> tuple[str, ...]:
        """Name the condition of each trial in time.

        conditions : names of all conditions, as the protocol lists them.
        slot : 0-based place of the participant in the study; a replacement takes over the slot.
        rng : the slot's own generator, for orders that draw.
        """
