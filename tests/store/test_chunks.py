from __future__ import annotations

import hashlib
import struct
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from numpy.typing import NDArray

from omnistudy.channel import Channel, Stream
from omnistudy.store.chunks import (
    ROWS_A_CHUNK,
    channels_from,
    chunks_of,
    columns_text,
    pack,
    real_values,
    unpack,
)

tables = arrays(
    np.float64,
    array_shapes(min_dims=2, max_dims=2, min_side=1, max_side=20),
    elements=st.floats(width=64),
)


@given(values=tables, t0=st.floats(0, 1e6))
def test_unpacking_gives_back_every_bit(values: NDArray[np.float64], t0: float) -> None:
    back = unpack(pack(values, t0), values.shape[1])
    assert back.tobytes() == values.tobytes()
    assert back.dtype == np.float64
    assert back.shape == values.shape


def test_packed_bytes_are_as_documented() -> None:
    chunk = pack(np.array([[1.0, 2.0], [3.0, 4.0]]), 0.0)
    plain = struct.pack("<4d", 1.0, 2.0, 3.0, 4.0)
    assert chunk.sha256 == hashlib.sha256(plain).hexdigest()
    # byte 7 (sign and exponent) of 1.0 is 0x3f, of 2.0, 3.0 and 4.0 it is 0x40
    shuffled = zlib.decompress(chunk.data)
    assert shuffled[7 * 2 : 8 * 2] == b"\x3f\x40"
    assert shuffled[15 * 2 : 16 * 2] == b"\x40\x40"


def test_views_and_other_orders_pack_alike() -> None:
    values = np.arange(24.0).reshape(6, 4)
    assert pack(np.asfortranarray(values), 0.0) == pack(values, 0.0)
    assert pack(values[::2], 0.0) == pack(values[::2].copy(), 0.0)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda chunk: chunk._replace(data=chunk.data[:-8]),
        lambda chunk: chunk._replace(data=b"rubbish"),
        lambda chunk: chunk._replace(rows=chunk.rows + 1),
        lambda chunk: chunk._replace(sha256="0" * 64),
    ],
)
def test_spoilt_chunks_are_noticed(spoil: object) -> None:
    assert callable(spoil)
    with pytest.raises(ValueError, match=r"chunk at 2\.5 s"):
        unpack(spoil(pack(np.ones((3, 2)), 2.5)), 2)


def test_long_streams_are_cut() -> None:
    rows = 2 * ROWS_A_CHUNK + 5
    stream = Stream("input", 240.0, (Channel("a", "m", "a"),), np.arange(float(rows))[:, None])
    chunks = list(chunks_of(stream))
    assert [chunk.rows for chunk in chunks] == [ROWS_A_CHUNK, ROWS_A_CHUNK, 5]
    assert [chunk.t0 for chunk in chunks] == [0.0, ROWS_A_CHUNK / 240, 2 * ROWS_A_CHUNK / 240]
    joined = np.concatenate([unpack(chunk, 1) for chunk in chunks])
    assert np.array_equal(joined, stream.data)


def test_empty_streams_have_no_chunk() -> None:
    assert list(chunks_of(Stream("input", 240.0, (), np.empty((0, 0))))) == []


def test_columns_keep_names_units_and_meanings() -> None:
    channels = (Channel("torque", "N·m", "at the hand"), Channel("late", "1", ""))
    assert channels_from(columns_text(channels)) == channels
    assert "N·m" in columns_text(channels)


def test_whole_counts_of_an_encoder_pack_small_and_come_back_bit_for_bit() -> None:
    count = 0.095 * np.pi / 180.0 / 12.0
    counts = np.round(300.0 * np.sin(np.arange(4000) / 37.0))
    stick = Channel("stick_x", "m", "travel", count)
    aware = Stream("input", 240.0, (stick,), (counts * count)[:, None])
    unaware = aware._replace(channels=(stick._replace(resolution=0.0),))

    (packed,), (plain,) = chunks_of(aware), chunks_of(unaware)
    assert real_values(unpack(packed, 1), aware.channels).tobytes() == aware.data.tobytes()
    assert len(packed.data) < 0.5 * len(plain.data)


def test_a_value_between_the_steps_is_refused() -> None:
    stick = Channel("stick_x", "m", "travel", 0.25)
    with pytest.raises(ValueError, match="'stick_x' has values between the steps"):
        list(chunks_of(Stream("input", 240.0, (stick,), np.array([[0.25], [0.3]]))))
