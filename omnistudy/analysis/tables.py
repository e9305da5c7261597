"""What every analysis is given: the tables of one study as frames."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import pandas as pd

from omnistudy.worlds import World


class Exclusion(NamedTuple):
    """An attempt that is left out, and why: a measure of it is above the protocol's limit."""

    trial: int
    measure: str
    value: float
    greatest: float
    unit: str


@dataclass(frozen=True, slots=True, eq=False)
class StudyTables:
    """One study as frames; whoever reads the store makes it.

    made_by : version of omnistudy that ran the study.
    trials : one row an attempt at a trial that counts: trial, participant, visit, position,
        attempt, condition, repetition, route, status, duration_s, collisions, collisions_legacy,
        and one column a factor.
    events : trial, t (s), kind, detail.
    participants : participant, kind.
    conditions : names in the protocol's order.
    samples : gives the `sample` rows (SAMPLE_COLUMNS) of a trial's number.
    world : where all trials were driven, None when there are several or none is known.
    factors : names of the factor columns of `trials`.
    exclusions : attempts that are not among `trials`, with the reason.
    """

    name: str
    title: str
    kind: str
    design_hash: str
    site_hash: str
    made_by: str
    trials: pd.DataFrame
    events: pd.DataFrame
    participants: pd.DataFrame
    conditions: tuple[str, ...]
    samples: Callable[[int], pd.DataFrame]
    world: World | None = None
    factors: tuple[str, ...] = ()
    exclusions: tuple[Exclusion, ...] = ()
