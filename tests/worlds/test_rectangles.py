"""Cells as rectangles: every true cell in one, no other cell in any."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from omnistudy.worlds.rectangles import Cells, Rectangle, rectangles

patterns = arrays(np.bool_, array_shapes(min_dims=2, max_dims=2, min_side=1, max_side=24))


def drawn(*rows: str) -> Cells:
    """Cells from rows of # and . in the order of their indices."""
    return np.array([[letter == "#" for letter in row] for row in rows])


@given(patterns)
def test_the_rectangles_are_the_cells_and_none_twice(cells: Cells) -> None:
    count = np.zeros(cells.shape, dtype=int)
    for column, row, columns, rows in rectangles(cells):
        count[row : row + rows, column : column + columns] += 1
    assert (count == cells).all()


@given(st.integers(1, 60), st.integers(1, 60))
def test_a_solid_block_is_one_rectangle(columns: int, rows: int) -> None:
    solid = np.ones((rows, columns), dtype=bool)
    assert list(rectangles(solid)) == [Rectangle(0, 0, columns, rows)]


def test_a_room_is_four_walls() -> None:
    room = drawn("######", "#....#", "#....#", "######")
    assert list(rectangles(room)) == [
        Rectangle(0, 0, 6, 1),
        Rectangle(0, 1, 1, 3),
        Rectangle(5, 1, 1, 3),
        Rectangle(1, 3, 4, 1),
    ]


def test_the_larger_of_wide_and_deep_is_taken() -> None:
    # From the corner three cells to the right, or two columns four down: eight beat three.
    assert list(rectangles(drawn("###", "##.", "##.", "##."))) == [
        Rectangle(0, 0, 2, 4),
        Rectangle(2, 0, 1, 1),
    ]
