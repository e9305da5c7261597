"""Collisions with feedback over the prior of the virtual driver's arm stiffness."""

from __future__ import annotations

from dataclasses import dataclass

import pandas as pd

from omnistudy.analysis.counting import counted
from omnistudy.analysis.estimate import Estimate, estimate
from omnistudy.analysis.outcomes import Value
from omnistudy.analysis.tables import StudyTables
from omnistudy.errors.analysis import NotAnArmStudy

FACTOR = "arm_stiffness_quantile"


@dataclass(frozen=True, slots=True)
class CurvePoint:
    """Collisions with feedback when every arm stands at one quantile of its prior.

    timed_out : how many of the trials ran out of time; they count with the collisions until then.
    """

    quantile: float
    condition: str
    collisions: Estimate
    timed_out: int
    values: tuple[Value, ...]


@dataclass(frozen=True, slots=True)
class PersonLine:
    """One participant's mean collisions at each quantile that they drove."""

    participant: str
    quantiles: tuple[float, ...]
    means: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class ArmStiffnessCurve:
    """The points from the most compliant to the stiffest arm, and which study they are of."""

    study: str
    points: tuple[CurvePoint, ...]
    lines: tuple[PersonLine, ...]
    method: str


def quantile_trials(tables: StudyTables) -> tuple[tuple[float, pd.DataFrame], ...]:
    """Give the trials at each quantile of the prior, rising; raises NotAnArmStudy."""
    if FACTOR not in tables.factors:
        raise NotAnArmStudy(tables.name, FACTOR, tables.factors)
    quantiles = tables.trials[FACTOR].astype(float)
    return tuple(
        (float(quantile), tables.trials[quantiles == quantile])
        for quantile in sorted(quantiles.dropna().unique())
    )


def arm_stiffness_curve(tables: StudyTables, column: str) -> ArmStiffnessCurve:
    """Give mean collisions with feedback at each quantile; raises NotAnArmStudy."""
    points = []
    for quantile, trials in quantile_trials(tables):
        ran = counted(trials).sort_values(["participant", "position"])
        values = tuple(
            Value(str(who), int(position), int(repetition), float(value))
            for who, position, repetition, value in ran[
                ["participant", "position", "repetition", column]
            ].itertuples(index=False)
        )
        condition = str(trials["condition"].iloc[0])
        timed_out = int((ran["status"] == "timed_out").sum())
        collisions = estimate((value.value for value in values), "1")
        points.append(CurvePoint(quantile, condition, collisions, timed_out, values))
    return ArmStiffnessCurve(
        tables.name,
        tuple(points),
        _lines(points),
        f"mean and sample SD of {column} over trials that ran, at each quantile of the prior",
    )


def _lines(points: list[CurvePoint]) -> tuple[PersonLine, ...]:
    people = sorted({value.participant for point in points for value in point.values})
    return tuple(_line(person, points) for person in people)


def _line(person: str, points: list[CurvePoint]) -> PersonLine:
    driven = {}
    for point in points:
        own = [value.value for value in point.values if value.participant == person]
        if own:
            driven[point.quantile] = sum(own) / len(own)
    return PersonLine(person, tuple(driven), tuple(driven.values()))
