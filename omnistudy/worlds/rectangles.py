"""A pattern of cells as few rectangles: every cell in exactly one of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Cells = NDArray[np.bool_]


class Rectangle(NamedTuple):
    """Whole cells: the first column and row, and how many of either."""

    column: int
    row: int
    columns: int
    rows: int

    @property
    def area(self) -> int:
        """Number of cells in it."""
        return self.columns * self.rows


def rectangles(cells: Cells) -> Iterator[Rectangle]:
    """Cover the true cells (rows, columns) with rectangles that do not overlap, greedily.

    From the first free cell in reading order the larger of two is taken: the whole run to the
    right as far down as it goes, or the run down as far to the right as it goes.
    """
    left = cells.copy()
    for row in np.flatnonzero(cells.any(axis=1)).tolist():
        for begin, end in _runs(left[row]):
            column = begin
            while column < end:
                taken = _larger(left, row, column, end)
                left[row : row + taken.rows, column : column + taken.columns] = False
                yield taken
                column += taken.columns


def _runs(line: Cells) -> Iterator[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(line.astype(np.int8), prepend=0, append=0))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


def _larger(left: Cells, row: int, column: int, end: int) -> Rectangle:
    wide_rows = _depth(left[row:, column:end])
    deep_rows = _depth(left[row:, column : column + 1])
    deep_columns = _depth(left[row : row + deep_rows, column:end].T)
    wide = Rectangle(column, row, end - column, wide_rows)
    deep = Rectangle(column, row, deep_columns, deep_rows)
    return wide if wide.area >= deep.area else deep


def _depth(cells: Cells) -> int:
    """Count the rows, from the first on, that are true from end to end."""
    looked, at_once = 0, 8
    while looked < len(cells):
        whole = cells[looked : looked + at_once].all(axis=1)
        if not whole.all():
            return looked + int(whole.argmin())
        looked += at_once
        at_once *= 2
    return len(cells)
