"""Rows between two processes: the writer never waits, and what it overwrote is counted as lost."""

from __future__ import annotations

import mmap
import struct
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

COUNT = struct.Struct("<Q")
SHAPE = struct.Struct("<QQ")
HEAD, TAIL, SHAPE_AT, ROWS_AT = 0, 8, 16, 32
"""Bytes at which stand: rows written, rows taken for good, width and capacity, the rows."""


class Rows(NamedTuple):
    """Rows in the order in which they were written.

    first : number of the first, counted from 0 since the ring was made.
    data : (n, width) float64.
    """

    first: int
    data: NDArray[np.float64]


class Ring:
    """Rows of float64 in a small file that both processes map into their memory.

    There is one writer and one reader at a time. A reader that dies is followed by another, which
    goes on after the last row that was taken for good.
    """

    def __init__(self, path: Path, width: int | None = None, capacity: int = 0) -> None:
        """Make the file for `capacity` rows of `width` numbers, or map the one that is there.

        Raises FileNotFoundError or ValueError (empty file) when there is none to map.
        """
        if width is not None:
            path.unlink(missing_ok=True)
            path.touch(mode=0o600)
            with path.open("r+b") as file:
                file.truncate(ROWS_AT + 8 * width * capacity)
        self.path = path
        with path.open("r+b") as file:
            self._memory = mmap.mmap(file.fileno(), 0)
        if width is not None:
            SHAPE.pack_into(self._memory, SHAPE_AT, width, capacity)
        self.width, self.capacity = SHAPE.unpack_from(self._memory, SHAPE_AT)
        self._row = struct.Struct(f"<{self.width}d")
        self._written = self.written

    @property
    def written(self) -> int:
        """Rows written so far."""
        return int(COUNT.unpack_from(self._memory, HEAD)[0])

    @property
    def taken(self) -> int:
        """Rows that the reader took for good, those that were overwritten before included."""
        return int(COUNT.unpack_from(self._memory, TAIL)[0])

    def append(self, row: tuple[float, ...]) -> None:
        """Write a row in place of the oldest; for the writer alone."""
        start = ROWS_AT + self._written % self.capacity * self._row.size
        self._row.pack_into(self._memory, start, *row)
        self._written += 1
        COUNT.pack_into(self._memory, HEAD, self._written)

    def read(self) -> Rows:
        """Give every row that was not taken yet and still is there; for the reader alone."""
        written = self.written
        first = max(self.taken, written - self.capacity)
        data = b"".join(self._pieces(first, written))
        # The row in the slot that comes next may be half overwritten by now.
        safe = max(first, min(written, self.written + 1 - self.capacity))
        rows = np.frombuffer(data, dtype="<f8").reshape(-1, self.width)
        return Rows(safe, rows[safe - first :])

    def take(self, until: int) -> None:
        """Note that all rows before number `until` are taken for good."""
        COUNT.pack_into(self._memory, TAIL, until)

    def close(self) -> None:
        """Let go of the memory; the file stays for whoever made it."""
        self._memory.close()

    def remove(self) -> None:
        """Let go and take the file away."""
        self.close()
        self.path.unlink(missing_ok=True)

    def _pieces(self, first: int, end: int) -> tuple[bytes, ...]:
        """Give the bytes of the rows first .. end-1, which may run over the end of the file."""
        size = self._row.size
        start = first % self.capacity
        count = end - first
        before = min(count, self.capacity - start)
        at = ROWS_AT + start * size
        return (
            self._memory[at : at + before * size],
            self._memory[ROWS_AT : ROWS_AT + (count - before) * size],
        )
