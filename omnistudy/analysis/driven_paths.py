"""Where the robot went and where it touched a wall."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from omnistudy.analysis.counting import counted
from omnistudy.analysis.tables import StudyTables
from omnistudy.metrics import path_length

SPACING = 0.1
"""m of way between two points that are kept for drawing (ours)."""
COLLISION = "collision"
"""Kind of the event that a new collision leaves."""

Column = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class DrivenPath:
    """One trial's way, thinned to SPACING: x, y in m; where its collisions began.

    length_m : of the way before thinning.
    """

    participant: str
    repetition: int
    route: str
    status: str
    length_m: float
    x: Column
    y: Column
    collision_x: Column
    collision_y: Column


@dataclass(frozen=True, slots=True, eq=False)
class DrivenPaths:
    """All ways of one condition."""

    condition: str
    paths: tuple[DrivenPath, ...]


def driven_paths(tables: StudyTables, conditions: Sequence[str]) -> tuple[DrivenPaths, ...]:
    """Give the ways of every trial that ran, by condition."""
    ran = counted(tables.trials).sort_values(["participant", "repetition"])
    starts = tables.events[tables.events["kind"] == COLLISION]
    return tuple(
        DrivenPaths(
            condition,
            tuple(
                _path(
                    trial,
                    tables.samples(int(trial["trial"])),
                    starts.loc[starts["trial"] == trial["trial"], "t"],
                )
                for _, trial in ran[ran["condition"] == condition].iterrows()
            ),
        )
        for condition in conditions
    )


def _path(trial: pd.Series, rows: pd.DataFrame, collision_times: pd.Series) -> DrivenPath:
    known = rows.dropna(subset=["x", "y"])
    t, x, y = (known[name].to_numpy(dtype=np.float64) for name in ("t", "x", "y"))
    kept = _thinned(x, y)
    when = collision_times.to_numpy(dtype=np.float64) if len(t) else np.empty(0)
    return DrivenPath(
        str(trial["participant"]),
        int(trial["repetition"]),
        str(trial["route"]),
        str(trial["status"]),
        path_length(x, y),
        x[kept],
        y[kept],
        np.interp(when, t, x) if len(when) else np.empty(0),
        np.interp(when, t, y) if len(when) else np.empty(0),
    )


def _thinned(x: Column, y: Column) -> NDArray[np.int64]:
    """Give the rows at which another SPACING of way is done, with the first and the last."""
    if len(x) < 2:
        return np.arange(len(x))
    way = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    steps = np.arange(0.0, way[-1], SPACING)
    return np.unique(np.append(np.searchsorted(way, steps), len(x) - 1))
