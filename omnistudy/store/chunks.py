"""Packing of stream rows: zlib over byte-shuffled float64."""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import Channel, Stream

ROWS_A_CHUNK = 4096
"""About 17 s at 240 Hz: large enough to pack well, small enough to read a piece alone."""

PACKING_LEVEL = 1
"""zlib's fastest; the shuffle has done most of the work by then."""


class Chunk(NamedTuple):
    """Rows of a stream as they lie in the table: t0 in s, SHA-256 of the unpacked bytes."""

    t0: float
    rows: int
    sha256: str
    data: bytes


def pack(values: NDArray[np.float64], t0: float) -> Chunk:
    """Pack (rows, columns) float64; the digest is of the little-endian bytes row by row."""
    plain = np.ascontiguousarray(values, dtype="<f8")
    rows, columns = plain.shape
    # All first bytes of the first column, then all its second bytes, ...: neighbours in time
    # differ in few of them, so that zlib finds long runs.
    shuffled = plain.view(np.uint8).reshape(rows, columns * 8).T
    return Chunk(
        t0=t0,
        rows=rows,
        sha256=hashlib.sha256(plain.tobytes()).hexdigest(),
        data=zlib.compress(shuffled.tobytes(), PACKING_LEVEL),
    )


def unpack(chunk: Chunk, columns: int) -> NDArray[np.float64]:
    """Give back (rows, columns) float64; raises ValueError when the bytes are not the packed."""
    try:
        shuffled = np.frombuffer(zlib.decompress(chunk.data), np.uint8)
    except zlib.error as error:
        raise ValueError(f"chunk at {chunk.t0} s cannot be unpacked: {error}") from error
    if shuffled.size != chunk.rows * columns * 8:
        raise ValueError(f"chunk at {chunk.t0} s has {shuffled.size} bytes instead of its rows")
    plain = np.ascontiguousarray(shuffled.reshape(columns * 8, chunk.rows).T)
    if hashlib.sha256(plain.tobytes()).hexdigest() != chunk.sha256:
        raise ValueError(f"chunk at {chunk.t0} s differs from its SHA-256")
    return plain.view("<f8").reshape(chunk.rows, columns).astype(np.float64, copy=False)


def chunks_of(stream: Stream) -> Iterator[Chunk]:
    """Cut a stream into packed chunks; none for a stream without rows."""
    stored = stored_numbers(stream.data, stream.channels)
    for first in range(0, len(stored), ROWS_A_CHUNK):
        yield pack(stored[first : first + ROWS_A_CHUNK], first / stream.rate_hz)


def stored_numbers(
    values: NDArray[np.float64], channels: tuple[Channel, ...]
) -> NDArray[np.float64]:
    """Turn values of channels with a resolution into whole numbers of steps, which pack small.

    Raises ValueError for a value that is no whole multiple: it would not come back bit for bit.
    """
    steps = _steps(channels)
    numbers = np.where(steps > 0.0, np.rint(values / np.where(steps > 0.0, steps, 1.0)), values)
    changed = ~np.isclose(
        real_values(numbers, channels), values, rtol=0.0, atol=0.0, equal_nan=True
    )
    if changed.any():
        name = channels[int(np.argwhere(changed)[0][1])].name
        raise ValueError(f"channel '{name}' has values between the steps of its resolution")
    return numbers


def real_values(numbers: NDArray[np.float64], channels: tuple[Channel, ...]) -> NDArray[np.float64]:
    """Turn stored numbers back into values."""
    steps = _steps(channels)
    values: NDArray[np.float64] = np.where(steps > 0.0, numbers * steps, numbers)
    return values


def _steps(channels: tuple[Channel, ...]) -> NDArray[np.float64]:
    return np.array([channel.resolution for channel in channels], dtype=np.float64)


def columns_text(channels: tuple[Channel, ...]) -> str:
    """Write channels as the JSON text of `stream.columns`."""
    return json.dumps([channel._asdict() for channel in channels], ensure_ascii=False)


def channels_from(text: str) -> tuple[Channel, ...]:
    """Read the JSON text of `stream.columns`."""
    return tuple(Channel(**column) for column in json.loads(text))
