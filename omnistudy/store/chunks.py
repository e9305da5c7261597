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
    for first in range(0, len(stream.data), ROWS_A_CHUNK):
        yield pack(stream.data[first : first + ROWS_A_CHUNK], first / stream.rate_hz)


def columns_text(channels: tuple[Channel, ...]) -> str:
    """Write channels as the JSON text of `stream.columns`."""
    return json.dumps([channel._asdict() for channel in channels], ensure_ascii=False)


def channels_from(text: str) -> tuple[Channel, ...]:
    """Read the JSON text of `stream.columns`."""
    return tuple(Channel(**column) for column in json.loads(text))
