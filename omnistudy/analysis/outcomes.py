"""Collisions and completion times by condition or trial label, with every value behind a mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd

from omnistudy.analysis.counting import completed, counted
from omnistudy.analysis.estimate import Estimate, estimate


@dataclass(frozen=True, slots=True)
class Place:
    """Which trials make one bar: a condition, and one repetition of it or all (None)."""

    label: str
    condition: str
    repetition: int | None = None
    average: bool = False
    """True for a mean over bars that stand beside it."""


@dataclass(frozen=True, slots=True)
class Value:
    """One trial's number, with who drove it where in the order."""

    participant: str
    position: int
    repetition: int
    value: float


@dataclass(frozen=True, slots=True)
class Bar:
    """One place, its estimate and the values that it is the mean of."""

    place: Place
    estimate: Estimate
    values: tuple[Value, ...]


@dataclass(frozen=True, slots=True)
class Outcomes:
    """One quantity over places. `left_out`: trials that ran but have no such number."""

    quantity: str
    unit: str
    bars: tuple[Bar, ...]
    left_out: int
    method: str


def by_condition(conditions: Sequence[str]) -> tuple[Place, ...]:
    """Give one place a condition, all repetitions together."""
    return tuple(Place(condition, condition) for condition in conditions)


def collisions(trials: pd.DataFrame, places: Sequence[Place], column: str) -> Outcomes:
    """Give collisions a trial from `column`, of every trial that ran, finished or out of time."""
    return _outcomes(
        "collisions",
        "1",
        counted(trials),
        column,
        places,
        left_out=0,
        method=f"mean and sample SD of {column} over trials that ran (completed or timed out)",
    )


def completion_times(trials: pd.DataFrame, places: Sequence[Place]) -> Outcomes:
    """Give completion times in s; trials out of time have none and are counted as left out."""
    ran = counted(trials)
    finished = completed(ran)
    return _outcomes(
        "completion time",
        "s",
        finished,
        "duration_s",
        places,
        left_out=len(ran) - len(finished),
        method="mean and sample SD of duration_s over completed trials",
    )


def _outcomes(
    quantity: str,
    unit: str,
    trials: pd.DataFrame,
    column: str,
    places: Sequence[Place],
    left_out: int,
    method: str,
) -> Outcomes:
    bars = tuple(_bar(place, trials, column, unit) for place in places)
    return Outcomes(quantity, unit, bars, left_out, method)


def _bar(place: Place, trials: pd.DataFrame, column: str, unit: str) -> Bar:
    chosen = trials[trials["condition"] == place.condition]
    if place.repetition is not None:
        chosen = chosen[chosen["repetition"] == place.repetition]
    ordered = chosen.sort_values(["participant", "position"])
    columns = ordered[["participant", "position", "repetition", column]]
    values = tuple(
        Value(str(who), int(position), int(repetition), float(value))
        for who, position, repetition, value in columns.itertuples(index=False)
    )
    return Bar(place, estimate((value.value for value in values), unit), values)
