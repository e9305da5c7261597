"""Trials with and without feedback of the same participants, side by side."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from omnistudy.analysis.counting import counted

Grid = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Pairs:
    """Grids of (participants, repetitions); NaN where a trial is missing or has no number.

    with_collisions, without_collisions : counts. with_times, without_times : s.
    """

    participants: tuple[str, ...]
    with_collisions: Grid
    without_collisions: Grid
    with_times: Grid
    without_times: Grid

    def drawn(self, rows: NDArray[np.int64]) -> Pairs:
        """Give the group made of these participants, some perhaps more than once."""
        return Pairs(
            tuple(self.participants[row] for row in rows),
            self.with_collisions[rows],
            self.without_collisions[rows],
            self.with_times[rows],
            self.without_times[rows],
        )


def pair(
    with_feedback: pd.DataFrame,
    without: pd.DataFrame,
    collision_column: str,
    participants: tuple[str, ...],
) -> Pairs:
    """Lay out two sets of trials (each of one condition) over the same participants."""
    return Pairs(
        participants,
        _grid(with_feedback, collision_column, participants),
        _grid(without, collision_column, participants),
        _grid(_timed(with_feedback), "duration_s", participants),
        _grid(_timed(without), "duration_s", participants),
    )


def _timed(trials: pd.DataFrame) -> pd.DataFrame:
    return trials[trials["status"] == "completed"]


def _grid(trials: pd.DataFrame, column: str, participants: tuple[str, ...]) -> Grid:
    ran = counted(trials)
    repetitions = int(ran["repetition"].max()) if len(ran) else 0
    grid = np.full((len(participants), repetitions), np.nan)
    rows = {code: row for row, code in enumerate(participants)}
    for code, repetition, value in ran[["participant", "repetition", column]].itertuples(
        index=False
    ):
        if code in rows:
            grid[rows[code], int(repetition) - 1] = value
    return grid
