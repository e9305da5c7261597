"""What every order can do: name the condition of the next trial."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from omnistudy.registry import KindModel
from omnistudy.seeds import generator, seed_text


class Seat(NamedTuple):
    """Where a participant sits among those who share an order: same stratum, same group.

    row : 0-based; a replacement takes over the seat.
    seed : shared by all seats of the stratum, the group and the block.
    """

    row: int
    seed: str

    def shared(self, purpose: str) -> np.random.Generator:
        """Make a generator that is the same for every seat."""
        return generator(self.seed, purpose)

    def own(self, purpose: str) -> np.random.Generator:
        """Make a generator of this seat alone."""
        return generator(seed_text(self.seed, self.row), purpose)


class PastTrial(NamedTuple):
    """A trial of the block that is over: its condition and what came of it.

    status : completed or timed_out. duration_s : s. collisions : debounced.
    """

    condition: str
    status: str
    duration_s: float
    collisions: int


class Order(KindModel, ABC):
    """Parameters of an order; pure, all that it draws comes from the seat."""

    @abstractmethod
    def next(
        self, conditions: Sequence[str], seat: Seat, history: Sequence[PastTrial]
    ) -> str | None:
        """Name the condition of the next trial, None when the block is over.

        conditions : names of those that the participant's group meets, as the protocol has them.
        history : the block's trials so far; only an order that adapts reads what came of them.
        """

    @abstractmethod
    def trials(self, conditions: Sequence[str]) -> int:
        """Say how many trials it gives."""

    def faults(self, conditions: Sequence[str]) -> Iterator[str]:
        """Say in one sentence each why it cannot order these conditions."""
        yield from ()


class PlannedOrder(Order):
    """An order that is known before the first trial: an author writes only `sequence`."""

    @abstractmethod
    def sequence(self, conditions: Sequence[str], seat: Seat) -> tuple[str, ...]:
        """Name the condition of each trial in time."""

    def next(
        self, conditions: Sequence[str], seat: Seat, history: Sequence[PastTrial]
    ) -> str | None:
        """Give the sequence's next condition, whatever happened."""
        sequence = self.sequence(conditions, seat)
        return sequence[len(history)] if len(history) < len(sequence) else None

    def trials(self, conditions: Sequence[str]) -> int:
        """Count the first seat's trials; every seat has as many."""
        return len(self.sequence(conditions, Seat(0, "")))

    def period(self, conditions: Sequence[str]) -> int:
        """Say after how many seats it balances what it promises; 1 when any number does."""
        return 1

    def imbalance(
        self, conditions: Sequence[str], sequences: Sequence[Sequence[str]]
    ) -> tuple[str, ...]:
        """Say what of its promise these seats' sequences do not keep, one sentence each."""
        return ()
