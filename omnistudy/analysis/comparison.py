"""The study set beside the thesis: every claim with our interval and a verdict.

The rule. A claim without feedback has a 95 % bootstrap interval over participants. A claim that
needs feedback has an interval over the prior of arm stiffness, which no trial without feedback can
reveal: from the lowest to the highest value over the quantiles of the arm-stiffness study, or,
without that study or where a number needs more than its one trial a quantile, over groups drawn
again from participants who each carry a draw of the prior.
A claim is a hit when its interval and ours have a value in common, a miss when they have none,
open when ours could not be computed (a test's p is never drawn again, so it needs the arm-stiffness
study); what the driver was calibrated on is neither, and whether it agrees is said all the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import pandas as pd

from omnistudy.analysis.arm_stiffness import quantile_trials
from omnistudy.analysis.estimate import UNKNOWN, Interval
from omnistudy.analysis.pairs import Pairs, pair
from omnistudy.analysis.published_utah2017 import CLAIMS, PublishedClaim
from omnistudy.analysis.statistics_utah2017 import STATISTICS, Statistic
from omnistudy.analysis.tables import StudyTables
from omnistudy.analysis.utah2017 import WITH, WITHOUT
from omnistudy.seeds import generator

Verdict = Literal["calibrated", "hit", "miss", "open"]
GROUPS = 2000
"""Groups drawn for a bootstrap interval."""

OVER_PRIOR = "range over the prior"
OVER_PARTICIPANTS = "95 % over participants"
OVER_DRAWS = "95 % over participants and their arms"


@dataclass(frozen=True, slots=True)
class ComparisonRow:
    """One claim beside this study.

    point : this study's own number; None for whatever needs feedback, which is never a point.
    """

    claim: PublishedClaim
    point: float | None
    interval: Interval
    method: str
    participants: int
    verdict: Verdict

    @property
    def agrees(self) -> bool:
        """Tell whether the thesis's value and our interval have a number in common."""
        return self.claim.reads_as.meets(self.interval)


def compare(
    tables: StudyTables, arm_study: StudyTables | None, column: str
) -> tuple[ComparisonRow, ...]:
    """Hold a study with the thesis's conditions against every claim; raises NotAnArmStudy."""
    trials = tables.trials
    without = trials[trials["condition"] == WITHOUT]
    own = pair(trials[trials["condition"] == WITH], without, column, _people(trials))
    over_prior = _groups_over_prior(arm_study, without, column)
    groups = _drawn_groups(own, tables.design_hash)
    return tuple(_row(claim, own, groups, over_prior, tables.design_hash) for claim in CLAIMS)


def _people(trials: pd.DataFrame) -> tuple[str, ...]:
    return tuple(sorted(str(code) for code in trials["participant"].unique()))


def _drawn_groups(own: Pairs, seed: str) -> list[Pairs]:
    people = len(own.participants)
    if not people:
        return []
    draw = generator(seed, "comparison with the thesis")
    return [own.drawn(draw.integers(0, people, size=people)) for _ in range(GROUPS)]


def _groups_over_prior(
    arm_study: StudyTables | None, without: pd.DataFrame, column: str
) -> list[Pairs]:
    """Give the group at each quantile: its trials with feedback beside our trials without."""
    if arm_study is None:
        return []
    people = _people(arm_study.trials)
    return [pair(trials, without, column, people) for _, trials in quantile_trials(arm_study)]


def _row(
    claim: PublishedClaim, own: Pairs, groups: list[Pairs], over_prior: list[Pairs], seed: str
) -> ComparisonRow:
    statistic = STATISTICS[claim.key]
    needs_feedback = claim.arm != "without"
    interval, method = UNKNOWN, OVER_PRIOR
    if needs_feedback:
        interval = _range(statistic, over_prior, seed)
    if not interval.known and claim.kind != "test":
        interval = _bootstrap(statistic, groups, seed)
        method = OVER_DRAWS if needs_feedback else OVER_PARTICIPANTS
    point = None if needs_feedback else statistic(own, seed)
    return ComparisonRow(
        claim, point, interval, method, len(own.participants), _verdict(claim, interval)
    )


def _verdict(claim: PublishedClaim, interval: Interval) -> Verdict:
    if claim.calibrated:
        return "calibrated"
    if not interval.known:
        return "open"
    return "hit" if claim.reads_as.meets(interval) else "miss"


def _range(statistic: Statistic, groups: list[Pairs], seed: str) -> Interval:
    """Give the range over groups; unknown unless the statistic exists in every one of them."""
    values = [statistic(group, seed) for group in groups]
    if not values or not np.isfinite(values).all():
        return UNKNOWN
    return Interval(min(values), max(values))


def _bootstrap(statistic: Statistic, groups: list[Pairs], seed: str) -> Interval:
    values = np.array([statistic(group, seed) for group in groups], dtype=np.float64)
    finite = values[np.isfinite(values)]
    if not finite.size:
        return UNKNOWN
    low, high = np.percentile(finite, [2.5, 97.5])
    return Interval(float(low), float(high))
