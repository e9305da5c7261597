"""How late the turns of a loop were, counted where another process can see it."""

from __future__ import annotations

import mmap
from pathlib import Path
from typing import NamedTuple

STEP_S = 1e-5
"""Width of a bin, s."""
BINS = 5000
"""Up to 50 ms; what is later is in the last one."""
TRIAL, LATEST, COUNTS = 0, 1, 2
"""Places of the trial's number, of the greatest lateness in steps, and of the first bin."""


class Lateness(NamedTuple):
    """Lateness of the turns of one trial, s, to STEP_S.

    late : turns that began when the next was due.
    """

    turns: int
    late: int
    median: float
    p99: float
    greatest: float


class Cadence:
    """Counts by lateness in a small mapped file; one process counts, another looks."""

    def __init__(self, path: Path, *, make: bool = False) -> None:
        """Make the file, or map the one that is there; raises FileNotFoundError when none is."""
        if make:
            path.write_bytes(bytes(4 * (COUNTS + BINS)))
        with path.open("r+b") as file:
            self._memory = mmap.mmap(file.fileno(), 0)
        self._numbers = memoryview(self._memory).cast("I")
        self._nothing = memoryview(bytes(len(self._memory))).cast("I")

    def begin(self, trial: int) -> None:
        """Forget what was counted and count for another trial."""
        self._numbers[:] = self._nothing
        self._numbers[TRIAL] = trial

    def count(self, seconds: float) -> None:
        """Count a turn that began so late."""
        steps = int(seconds / STEP_S)
        numbers = self._numbers
        if steps > numbers[LATEST]:
            numbers[LATEST] = steps
        numbers[COUNTS + (steps if steps < BINS else BINS - 1)] += 1

    def lateness(self, trial: int, period: float) -> Lateness | None:
        """Tell how late a trial's turns were; None when another's or none were counted.

        period : from turn to turn, s.
        """
        if self._numbers[TRIAL] != trial:
            return None
        counts = self._numbers[COUNTS:].tolist()
        turns = sum(counts)
        if not turns:
            return None
        late = sum(counts[round(period / STEP_S) :])
        greatest = self._numbers[LATEST] * STEP_S
        return Lateness(turns, late, _quantile(counts, 0.5), _quantile(counts, 0.99), greatest)

    def close(self) -> None:
        """Let go of the memory."""
        self._numbers.release()
        self._memory.close()


def _quantile(counts: list[int], share: float) -> float:
    """Give the upper edge of the bin that holds the quantile, s."""
    wanted = share * sum(counts)
    so_far = 0
    for steps, count in enumerate(counts):
        so_far += count
        if so_far >= wanted:
            return (steps + 1) * STEP_S
    return len(counts) * STEP_S
