"""What the law made the hand feel: force and torque over time, one trial a condition."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from omnistudy.analysis.counting import completed, counted
from omnistudy.analysis.tables import StudyTables
from omnistudy.scene import Region

PART = "green"
"""The part of the map whose torque the thesis draws (Tyagi 2017, Fig. 5.6)."""
FIRST_SECONDS = 60.0
"""What is drawn where the world has no such part."""


@dataclass(frozen=True, slots=True, eq=False)
class WrenchTrace:
    """Samples of one trial: t in s since the trial opened; fx, fy in N, tau in N·m, unclipped.

    part : which stretch of the trial it is.
    share_felt : share of the samples with any force or torque.
    """

    condition: str
    participant: str
    repetition: int
    part: str
    t: NDArray[np.float64]
    fx: NDArray[np.float64]
    fy: NDArray[np.float64]
    tau: NDArray[np.float64]
    share_felt: float

    def largest(self) -> tuple[float, float, float]:
        """Give the largest magnitude of fx, fy (N) and tau (N·m); 0 without a sample."""
        return _largest(self.fx), _largest(self.fy), _largest(self.tau)


def _largest(column: NDArray[np.float64]) -> float:
    return float(np.nanmax(np.abs(column))) if np.isfinite(column).any() else 0.0


def wrench_traces(tables: StudyTables, conditions: Sequence[str]) -> tuple[WrenchTrace, ...]:
    """Give the first completed repetition of every condition, all of one participant.

    That participant is the first, by code, who completed the most conditions; a condition that
    they did not complete is left out.
    """
    finished = completed(counted(tables.trials))
    if finished.empty:
        return ()
    participant = _who_completed_most(finished)
    own = finished[finished["participant"] == participant].sort_values("repetition")
    traces = []
    for condition in conditions:
        chosen = own[own["condition"] == condition]
        if len(chosen):
            trial = chosen.iloc[0]
            rows = tables.samples(int(trial["trial"]))
            traces.append(_trace(trial, rows, _part(tables)))
    return tuple(traces)


def _who_completed_most(finished: pd.DataFrame) -> str:
    conditions = finished.groupby("participant")["condition"].nunique()
    return str(min(conditions[conditions == conditions.max()].index))


def _part(tables: StudyTables) -> tuple[Region, ...]:
    regions = tables.world.regions if tables.world else ()
    return tuple(region for region in regions if region.group == PART)


def _trace(trial: pd.Series, rows: pd.DataFrame, regions: tuple[Region, ...]) -> WrenchTrace:
    cut, part = rows[rows["t"] <= FIRST_SECONDS], f"the first {FIRST_SECONDS:g} s"
    if regions:
        inside = _inside(rows, regions)
        if inside.any():
            cut, part = rows[inside], f"the {PART} part of the map"
    columns = cut[["t", "fx", "fy", "tau"]].to_numpy(dtype=np.float64)
    felt = np.any(np.nan_to_num(columns[:, 1:]) != 0.0, axis=1)
    return WrenchTrace(
        str(trial["condition"]),
        str(trial["participant"]),
        int(trial["repetition"]),
        part,
        t=columns[:, 0],
        fx=columns[:, 1],
        fy=columns[:, 2],
        tau=columns[:, 3],
        share_felt=float(felt.mean()) if len(felt) else 0.0,
    )


def _inside(rows: pd.DataFrame, regions: tuple[Region, ...]) -> NDArray[np.bool_]:
    places = zip(rows["x"], rows["y"], strict=True)
    return np.array(
        [any(region.contains(x, y) for region in regions) for x, y in places], dtype=np.bool_
    )
