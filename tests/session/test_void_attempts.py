"""A void attempt is kept, followed by another, and in no plan, count or number."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import nan
from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.analysis.report import analyse
from omnistudy.errors.session import AlwaysVoid
from omnistudy.protocol import Protocol
from omnistudy.protocol.seeds import trial_seed
from omnistudy.report.source import study_tables
from omnistudy.session import RunSummary, run_trials
from omnistudy.store import StoredTrial
from omnistudy.study import plan_session
from omnistudy.study.status import study_status
from omnistudy.trial import TrialResult, TrialSpec

DONE = TrialResult(
    status="completed",
    reason="",
    duration_s=10.0,
    path_length_m=3.0,
    collisions=1,
    collisions_legacy=1,
    contact_time_s=0.0,
    events=(),
    samples=np.full((2, 13), np.arange(2.0)[:, None]),
    streams=(),
)
VOID = replace(DONE, status="void", reason="the cable is off", duration_s=nan)


def run(study: Path, limit: int, void: Sequence[tuple[int, int]]) -> RunSummary:
    """Stand in for trials: those at (position, attempt) are void, the others completed."""

    def drive(ready: Sequence[StoredTrial], specs: Iterator[TrialSpec]) -> Iterator[TrialResult]:
        for trial, _ in zip(ready, specs, strict=True):
            yield VOID if (trial.position, trial.attempt) in void else DONE

    return run_trials(study, limit=limit, run=drive)


def test_the_next_attempt_is_driven_at_once_with_a_seed_of_its_own(
    short_study: Path, short_protocol: Protocol
) -> None:
    summary = run(short_study, 2, void=[(1, 1), (1, 2)])
    assert (summary.void, summary.completed, summary.remaining) == (2, 2, 10)
    with omnistudy.open(short_study) as study:
        ran = study.trials()[lambda table: table["status"] != "planned"]
        design = study.study.design_hash
    assert ran[["position", "attempt", "status"]].values.tolist() == [
        [1, 1, "void"],
        [1, 2, "void"],
        [1, 3, "completed"],
        [2, 1, "completed"],
    ]
    assert list(ran["reason"][:2]) == ["the cable is off"] * 2
    key = short_protocol.participants.study_key
    assert list(ran["seed"][:3]) == [trial_seed(design, key, 0, 1, 1, n) for n in (1, 2, 3)]
    assert ran[["condition", "route", "repetition"]][:3].drop_duplicates().shape[0] == 1


def test_three_in_a_row_end_the_session_and_the_next_one_goes_on(short_study: Path) -> None:
    with pytest.raises(AlwaysVoid, match=r"trial 1 of P01 was void 3 times.*the cable is off"):
        run(short_study, 1, void=[(1, 1), (1, 2), (1, 3)])
    summary = run(short_study, 1, void=[])
    assert (summary.completed, summary.remaining) == (1, 11)
    with omnistudy.open(short_study) as study:
        assert study.trials().iloc[3][["attempt", "status"]].tolist() == [4, "completed"]


def test_void_attempts_are_in_no_plan_count_or_number(short_study: Path) -> None:
    run(short_study, 2, void=[(1, 1), (2, 1)])
    with omnistudy.open(short_study) as study:
        first = study_status(study).participants[0]
        plan = plan_session(study, "P01")
        report = analyse(study_tables(study))
        assert "2 of 12 trials completed" in repr(study)
    assert (first.completed, first.planned, first.other) == (2, 4, 0)
    assert [trial.position for trial in plan] == [1, 2, 3, 4, 5, 6]
    assert sum(bar.estimate.n for bar in report.collisions.bars) == 2
    assert sum(count.of("void") for count in report.attempts) == 2
