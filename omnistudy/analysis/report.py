"""All numbers of the first report, as one value."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import version

from omnistudy.analysis.arm_stiffness import ArmStiffnessCurve, arm_stiffness_curve
from omnistudy.analysis.comparison import ComparisonRow, compare
from omnistudy.analysis.counting import ConditionCount, count_attempts
from omnistudy.analysis.driven_paths import DrivenPaths, driven_paths
from omnistudy.analysis.event_counts import EventCount, count_events
from omnistudy.analysis.outcomes import Outcomes, by_condition, collisions, completion_times
from omnistudy.analysis.pairs import pair
from omnistudy.analysis.statistics_utah2017 import best_participant, worst_participant
from omnistudy.analysis.tables import Exclusion, StudyTables
from omnistudy.analysis.utah2017 import (
    AVERAGES,
    CONDITIONS,
    LABELS,
    WITH,
    WITHOUT,
    is_utah2017,
)
from omnistudy.analysis.wrench import WrenchTrace, wrench_traces
from omnistudy.errors.analysis import MixedKinds
from omnistudy.version import VERSION

COLLISIONS = "collisions_legacy"
"""The count that is set beside the thesis: every rising edge, as it counted (App. B)."""


@dataclass(frozen=True, slots=True)
class StudyFacts:
    """What was analysed, and by which software."""

    name: str
    title: str
    kind: str
    design_hash: str
    site_hash: str
    made_by: str
    participants: int
    conditions: tuple[str, ...]
    software: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Subject:
    """The best or the worst participant's own collisions."""

    participant: str
    collisions: Outcomes


@dataclass(frozen=True, slots=True, eq=False)
class Report:
    """Numbers with units, methods and n; pages draw it and compute nothing.

    by_label, times_by_label, best, worst, comparison: only for the thesis's conditions.
    """

    study: StudyFacts
    attempts: tuple[ConditionCount, ...]
    collisions: Outcomes
    collisions_debounced: Outcomes
    times: Outcomes
    events: tuple[EventCount, ...]
    wrenches: tuple[WrenchTrace, ...]
    paths: tuple[DrivenPaths, ...]
    collisions_by_label: Outcomes | None
    times_by_label: Outcomes | None
    best: Subject | None
    worst: Subject | None
    comparison: tuple[ComparisonRow, ...]
    arm_stiffness: ArmStiffnessCurve | None
    exclusions: tuple[Exclusion, ...]


def analyse(tables: StudyTables, arm_study: StudyTables | None = None) -> Report:
    """Compute the report of a study; raises MixedKinds, NotAnArmStudy."""
    _one_kind(tables)
    if arm_study is not None:
        _one_kind(arm_study)
    published = is_utah2017(tables.conditions)
    conditions = CONDITIONS if published else tables.conditions
    trials = tables.trials
    places = by_condition(conditions)
    best, worst = _subjects(tables) if published else (None, None)
    labels = (*LABELS, *AVERAGES)
    return Report(
        study=_facts(tables, conditions),
        attempts=count_attempts(trials, conditions),
        collisions=collisions(trials, places, COLLISIONS),
        collisions_debounced=collisions(trials, places, "collisions"),
        times=completion_times(trials, places),
        events=count_events(trials, tables.events, conditions),
        wrenches=wrench_traces(tables, conditions),
        paths=driven_paths(tables, conditions),
        collisions_by_label=collisions(trials, labels, COLLISIONS) if published else None,
        times_by_label=completion_times(trials, labels) if published else None,
        best=best,
        worst=worst,
        comparison=compare(tables, arm_study, COLLISIONS) if published else (),
        arm_stiffness=arm_stiffness_curve(arm_study, COLLISIONS) if arm_study else None,
        exclusions=tables.exclusions,
    )


def _one_kind(tables: StudyTables) -> None:
    if set(tables.participants["kind"]) - {tables.kind}:
        raise MixedKinds(tables.name)


def _facts(tables: StudyTables, conditions: tuple[str, ...]) -> StudyFacts:
    return StudyFacts(
        tables.name,
        tables.title,
        tables.kind,
        tables.design_hash,
        tables.site_hash,
        tables.made_by,
        len(tables.participants),
        conditions,
        (
            ("omnistudy", VERSION),
            ("numpy", version("numpy")),
            ("pandas", version("pandas")),
        ),
    )


def _subjects(tables: StudyTables) -> tuple[Subject | None, Subject | None]:
    trials = tables.trials
    people = tuple(sorted(str(code) for code in trials["participant"].unique()))
    pairs = pair(
        trials[trials["condition"] == WITH],
        trials[trials["condition"] == WITHOUT],
        COLLISIONS,
        people,
    )
    return _subject(tables, best_participant(pairs)), _subject(tables, worst_participant(pairs))


def _subject(tables: StudyTables, participant: str | None) -> Subject | None:
    if participant is None:
        return None
    own = tables.trials[tables.trials["participant"] == participant]
    return Subject(participant, collisions(own, (*LABELS, *AVERAGES), COLLISIONS))
