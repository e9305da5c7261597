"""Numbers logged at irregular instants: read from CSV, trimmed, and looked up at any instant."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.operators import (
    NoRecording,
    NoRows,
    NoSuchColumn,
    NotANumber,
    TimeRunsBackwards,
)

Between = Literal["hold", "linear"]
"""What stands between two rows: the earlier one, or the straight line from one to the other."""

STAMP_RESOLUTION = 1e-6
"""s; stamps that count from 1970 resolve a quarter of this, so nothing finer is told apart."""


@dataclass(frozen=True, slots=True, eq=False)
class CommandLog:
    """What was logged, one row an instant, in the order of time.

    times : (n,) s, strictly increasing, as the log's own clock has them.
    values : (n, axes), in the units of the log.
    """

    times: NDArray[np.float64]
    values: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """Time in s from the first row to the last."""
        return float(self.times[-1] - self.times[0])

    @property
    def moves(self) -> bool:
        """Whether any axis of any row is not zero."""
        return bool(self.values.any())

    def without_idle(self) -> CommandLog:
        """Cut the rows at rest before the first motion and after the last.

        The first row at rest after the last motion stays, because it is what ends that motion.
        """
        moving = np.flatnonzero(self.values.any(axis=1))
        if len(moving) == 0:
            return self
        kept = slice(int(moving[0]), int(moving[-1]) + 2)
        return CommandLog(self.times[kept], self.values[kept])

    def at(
        self, instants: NDArray[np.float64], between: Between, longest_gap: float | None
    ) -> NDArray[np.float64]:
        """Give what was asked for at instants of the log's clock, (m,) s -> (m, axes).

        longest_gap : s after which a row that nothing has followed counts no more; the axes are
            then zero until the next row. None lets it stand. Two rows further apart than this are
            not joined by a line either.
        Before the first row all axes are zero; after the last it stands, as far as the gap allows.
        """
        times, values = self.times, self.values
        row = np.searchsorted(times, instants + STAMP_RESOLUTION, side="right") - 1
        row, early = np.maximum(row, 0), row < 0
        after = np.minimum(row + 1, len(times) - 1)
        age, span = np.maximum(instants - times[row], 0.0), times[after] - times[row]
        asked = values[row]
        if between == "linear":
            joined = (span > 0.0) & ((longest_gap is None) | (span <= (longest_gap or 0.0)))
            share = np.where(joined, np.minimum(age / np.where(span > 0.0, span, 1.0), 1.0), 0.0)
            asked = asked + share[:, None] * (values[after] - asked)
            age = np.where(joined, 0.0, age)
        unheard = early if longest_gap is None else early | (age > longest_gap + STAMP_RESOLUTION)
        asked[unheard] = 0.0
        return asked


def read_log(file: Path, time: str, columns: Sequence[str | None]) -> CommandLog:
    """Read columns of a CSV file by name; None stands for a column of zeros.

    Of rows with the same stamp the last counts. Raises NoRecording, NoSuchColumn, NotANumber,
    TimeRunsBackwards, NoRows.
    """
    times: list[float] = []
    values: list[tuple[float, ...]] = []
    for line, (stamp, *row) in _rows(file, (time, *columns)):
        if times and stamp < times[-1]:
            raise TimeRunsBackwards(file, line, times[-1], stamp)
        if times and stamp == times[-1]:
            values[-1] = tuple(row)
        else:
            times.append(stamp)
            values.append(tuple(row))
    if not times:
        raise NoRows(file)
    return CommandLog(np.array(times), np.array(values) + 0.0)


def _rows(file: Path, columns: Sequence[str | None]) -> Iterator[tuple[int, list[float]]]:
    try:
        with file.open(encoding="utf-8-sig", newline="") as opened:
            reader = csv.reader(opened, skipinitialspace=True)
            heading = [name.strip() for name in next(reader, [])]
            if not heading:
                raise NoRecording(file, "it is empty")
            places = [_place(file, name, heading) for name in columns]
            for cells in reader:
                if any(cells):
                    yield (
                        reader.line_num,
                        [_number(file, reader.line_num, heading, cells, place) for place in places],
                    )
    except FileNotFoundError:
        raise NoRecording(file, "there is no such file") from None
    except (OSError, UnicodeDecodeError, csv.Error) as cause:
        raise NoRecording(file, f"it cannot be read ({cause})") from cause


def _place(file: Path, name: str | None, heading: list[str]) -> int | None:
    if name is not None and name not in heading:
        raise NoSuchColumn(file, name, heading)
    return None if name is None else heading.index(name)


def _number(
    file: Path, line: int, heading: list[str], cells: list[str], place: int | None
) -> float:
    if place is None:
        return 0.0
    text = cells[place] if place < len(cells) else ""
    try:
        number = float(text)
    except ValueError:
        raise NotANumber(file, line, heading[place], text) from None
    if not isfinite(number):
        raise NotANumber(file, line, heading[place], text)
    return number
