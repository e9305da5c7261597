"""The latest value between two processes: the writer never waits, readers skip what they missed."""

from __future__ import annotations

import mmap
import struct
from pathlib import Path
from types import TracebackType
from typing import NamedTuple, Self
from zlib import crc32

HEADER = struct.Struct("<Q")
"""Number of the value written last; 0 before the first."""
SLOT = struct.Struct("<QII")
"""Number, length in bytes and CRC-32 of the value in a slot; the CRC begins at the number."""
TRIES = 8
"""Looks of a reader whose slot is written anew under its eyes."""


class Value(NamedTuple):
    """Bytes with their number, which counts from 1."""

    number: int
    data: bytes


class LatestValue:
    """One value of bytes in a small file that both processes map into their memory.

    There is one writer. Values go into two slots by turns, so that a reader finds the one before
    whole while the next is being written; number and checksum tell when that went wrong.
    """

    def __init__(self, path: Path, capacity: int | None = None) -> None:
        """Make the file for values of up to `capacity` bytes, or map the one that is there.

        Raises FileNotFoundError or ValueError (empty file) when there is none to map.
        """
        if capacity is not None:
            path.unlink(missing_ok=True)
            path.touch(mode=0o600)
            with path.open("r+b") as file:
                file.truncate(HEADER.size + 2 * (SLOT.size + capacity))
        self._path = path
        with path.open("r+b") as file:
            self._memory = mmap.mmap(file.fileno(), 0)
        self._slot_size = (len(self._memory) - HEADER.size) // 2
        self._number: int = HEADER.unpack_from(self._memory)[0]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def write(self, data: bytes) -> None:
        """Put a value in place of the last; raises ValueError for one above the capacity."""
        if SLOT.size + len(data) > self._slot_size:
            raise ValueError(f"{len(data)} bytes are more than the {self._slot_size - SLOT.size}")
        self._number += 1
        start = self._start(self._number)
        body = start + SLOT.size
        self._memory[body : body + len(data)] = data
        SLOT.pack_into(self._memory, start, self._number, len(data), _checksum(self._number, data))
        HEADER.pack_into(self._memory, 0, self._number)

    def read(self) -> Value | None:
        """Give the latest whole value; None before the first, or when none could be had whole."""
        for _ in range(TRIES):
            number: int = HEADER.unpack_from(self._memory)[0]
            start = self._start(number)
            found, length, checksum = SLOT.unpack_from(self._memory, start)
            body = start + SLOT.size
            data = self._memory[body : body + length]
            if number and found == number and _checksum(number, data) == checksum:
                return Value(number, data)
        return None

    def close(self) -> None:
        """Let go of the memory; the file stays for whoever made it."""
        self._memory.close()

    def remove(self) -> None:
        """Let go and take the file away."""
        self.close()
        self._path.unlink(missing_ok=True)

    def _start(self, number: int) -> int:
        return HEADER.size + (number % 2) * self._slot_size


def _checksum(number: int, data: bytes) -> int:
    """Bind a value to its number: a slot's header may be read while it is being written."""
    return crc32(data, number & 0xFFFFFFFF)
