"""Attempts above a protocol's limits are in no number, and the page says which and why."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.analysis.report import analyse
from omnistudy.channel import measured
from omnistudy.protocol.compose import compose_protocol
from omnistudy.report.source import study_tables
from omnistudy.report.words import left_out
from omnistudy.store import StudyWriter, TrialOutcome
from omnistudy.study import create_study

OUTCOME = TrialOutcome(
    status="completed",
    reason="",
    duration_s=10.0,
    path_length_m=3.0,
    collisions=1,
    collisions_legacy=1,
    contact_time_s=0.1,
)
SHORT = ("world=primitive_c", "routes=[through]", "participants.count=1")


@pytest.fixture
def study(tmp_path: Path) -> Path:
    """Four trials that ran, one void; the third has 9 late steps where 3 are the limit."""
    path = tmp_path / "limited.db"
    limits = ("+limits=[{measure: late_steps, greatest: 3}]",)
    protocol = compose_protocol("utah2017_williams", (*SHORT, *limits))
    create_study(protocol, path, "limited")
    with StudyWriter.open(path) as writer:
        main = [trial for trial in writer.planned_trials() if trial.kind == "main"]
        for trial, late, status in zip(
            main, (0, 3, 9, 0), (*["completed"] * 3, "void"), strict=False
        ):
            writer.start_trial(trial.id)
            outcome = replace(OUTCOME, status=status)
            measures = (measured("late_steps", late),)
            writer.finish_trial(trial.id, outcome, (), np.empty((0, 13)), (), None, measures)
    return path


def test_what_is_above_a_limit_or_void_is_in_no_number(study: Path) -> None:
    with omnistudy.open(study) as opened:
        tables = study_tables(opened)
        report = analyse(tables)
        third = int(opened.exclusions()["trial"].iloc[0])
    assert third not in set(tables.trials["trial"])
    assert sum(bar.estimate.n for bar in report.collisions.bars) == 2
    assert left_out(report) == (
        "Left out of all numbers, being above the protocol's limits: "
        f"trial {third} (late steps 9, limit 3)."
    )
