"""Rows go through the ring in order, and what was overwritten is told by the numbers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.channel import Ring


@pytest.fixture(scope="session")
def make_ring(tmp_path_factory: pytest.TempPathFactory) -> Callable[[], tuple[Ring, Ring]]:
    def make() -> tuple[Ring, Ring]:
        path = tmp_path_factory.mktemp("ring") / "rows"
        return Ring(path, width=2, capacity=4), Ring(path)

    return make


def test_rows_come_in_order_until_they_are_taken(
    make_ring: Callable[[], tuple[Ring, Ring]],
) -> None:
    writer, reader = make_ring()
    writer.append((1.0, 10.0))
    writer.append((2.0, 20.0))
    for _ in range(2):
        assert reader.read().data.tolist() == [[1.0, 10.0], [2.0, 20.0]]
    reader.take(1)
    assert reader.read().first == 1
    assert reader.read().data.tolist() == [[2.0, 20.0]]


@given(st.lists(st.integers(0, 7), max_size=12))
def test_every_row_is_read_once_or_known_to_be_lost(
    make_ring: Callable[[], tuple[Ring, Ring]], bursts: list[int]
) -> None:
    writer, reader = make_ring()
    written, read, lost = 0, [], 0
    for burst in bursts:
        for _ in range(burst):
            writer.append((float(written), 0.0))
            written += 1
        first, data = reader.read()
        lost += first - reader.taken
        read.extend(data[:, 0].tolist())
        reader.take(first + len(data))
    assert read == sorted(read)
    assert len(read) + lost == written == reader.taken
    # One slot of the four is always the writer's.
    assert lost == sum(max(0, burst - 3) for burst in bursts)


def test_a_successor_goes_on_where_the_last_reader_took(tmp_path: Path) -> None:
    writer = Ring(tmp_path / "rows", width=1, capacity=100)
    for number in range(10):
        writer.append((float(number),))
    first = Ring(tmp_path / "rows")
    first.take(6)
    first.close()
    writer.append((10.0,))
    successor = Ring(tmp_path / "rows")
    np.testing.assert_array_equal(successor.read().data[:, 0], [6.0, 7.0, 8.0, 9.0, 10.0])
