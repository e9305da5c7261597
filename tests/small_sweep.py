"""A sweep that takes a moment: two gains by two arms, out of time after five simulated seconds."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pandas as pd

from omnistudy.session.sweep.folder import SweepFolder, table
from omnistudy.session.sweep.planning import Question, SweepPlan, Thinning, plan_sweep

PROTOCOL = "utah2017_component"
SHORT = (
    "world=primitive_c",
    "routes=[through]",
    "participants.count=2",
    "task.time_limit=0.3",
)
GAINS = "law.stiffness.x=100,400"
ARMS = "operator.arm.stiffness_median=100,300"
ONE_TRIAL = Thinning(trials=1)


def question(*words: str, thinning: Thinning = ONE_TRIAL, **rest: Any) -> Question:
    """Ask the short protocol, one trial a participant."""
    return Question(PROTOCOL, (*words, *SHORT), thinning=thinning, **rest)


@cache
def small_plan(*words: str, **rest: Any) -> SweepPlan:
    """Plan once whatever several tests ask."""
    return plan_sweep(question(*(words or (GAINS, ARMS)), **rest))


def opened(path: Path, plan: SweepPlan) -> SweepFolder:
    """Give the folder of a planned sweep."""
    folder = SweepFolder(path)
    folder.open(plan.sweep)
    return folder


def rows_of(folder: SweepFolder) -> pd.DataFrame:
    """Give the table of what is finished."""
    return table(folder.question(), folder.finished())
