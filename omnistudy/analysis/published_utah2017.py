"""What Tyagi 2017 reports of collisions and times, each number with its place in the text.

The bar plots 5.1-5.4 are lost in the text we have; these are the numbers and claims that its
sentences give (sec. 5.1, pp. 50-55).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Literal

from omnistudy.analysis.estimate import Interval

Arm = Literal["with", "without", "both"]
ClaimKind = Literal["mean", "count", "approximate", "direction", "test"]


@dataclass(frozen=True, slots=True)
class PublishedClaim:
    """One claim of the thesis.

    printed : as the text puts it, shortened. reads_as : the values that we accept as agreeing.
    arm : which trials it is about; whatever needs trials with feedback depends on arm stiffness.
    kind : a mean printed as a whole number (read as within 0.5), a count (exact), a number called
        approximate (read as within 10 %, ours), a direction or a test.
    """

    key: str
    quantity: str
    printed: str
    reads_as: Interval
    unit: str
    arm: Arm
    kind: ClaimKind
    source: str
    calibrated: bool = False
    """True when the virtual driver was calibrated on this very number."""


def _mean(value: float) -> Interval:
    return Interval(value - 0.5, value + 0.5)


def _about(value: float) -> Interval:
    return Interval(0.9 * value, 1.1 * value)


def _count(value: float) -> Interval:
    return Interval(value, value)


FIGURE_1 = "sec. 5.1, Fig. 5.1 (p. 51)"
FIGURE_2 = "sec. 5.1, Fig. 5.2 (p. 52)"
FIGURE_3 = "sec. 5.1, Fig. 5.3 (p. 53)"
FIGURE_4 = "sec. 5.1, Fig. 5.4 (p. 54)"

CLAIMS = (
    PublishedClaim(
        "mean_without",
        "Mean collisions without feedback",
        "34",
        _mean(34.0),
        "1",
        "without",
        "mean",
        FIGURE_1,
        calibrated=True,
    ),
    PublishedClaim(
        "mean_with", "Mean collisions with feedback", "5", _mean(5.0), "1", "with", "mean", FIGURE_1
    ),
    PublishedClaim(
        "third_without",
        "Mean collisions in the third trial without feedback",
        "around 25",
        _about(25.0),
        "1",
        "without",
        "approximate",
        FIGURE_1,
    ),
    PublishedClaim(
        "share_zero_with",
        "Share of participants who reach zero collisions by the third trial with feedback",
        "most users converge to zero, as early as trial 2",
        Interval(0.5, 1.0),
        "1",
        "with",
        "direction",
        FIGURE_1,
    ),
    PublishedClaim(
        "learning_with",
        "Third trial over first, with feedback",
        "decreases substantially",
        Interval(0.0, 0.8),
        "1",
        "with",
        "direction",
        FIGURE_1,
    ),
    PublishedClaim(
        "learning_without",
        "Third trial over first, without feedback",
        "decreases substantially",
        Interval(0.0, 0.8),
        "1",
        "without",
        "direction",
        FIGURE_1,
    ),
    PublishedClaim(
        "p_collisions",
        "p of collisions, with against without",
        "reduced, 99 % confidence (ANOVA)",
        Interval(0.0, 0.01),
        "1",
        "both",
        "test",
        "sec. 5.2 (p. 55)",
    ),
    PublishedClaim(
        "time_ratio",
        "Completion time with over without feedback",
        "a little less with feedback",
        Interval(0.9, 1.0),
        "1",
        "both",
        "direction",
        FIGURE_2,
    ),
    PublishedClaim(
        "p_time",
        "p of completion time, with against without",
        "no significant difference",
        Interval(0.05, inf),
        "1",
        "both",
        "test",
        FIGURE_2,
    ),
    PublishedClaim(
        "best_without_mean",
        "Best participant: mean without feedback",
        "17",
        _mean(17.0),
        "1",
        "without",
        "mean",
        FIGURE_3,
        calibrated=True,
    ),
    PublishedClaim(
        "best_without_max",
        "Best participant: most without feedback",
        "19",
        _count(19.0),
        "1",
        "without",
        "count",
        FIGURE_3,
    ),
    PublishedClaim(
        "best_without_last",
        "Best participant: last trial without feedback",
        "18",
        _count(18.0),
        "1",
        "without",
        "count",
        FIGURE_3,
    ),
    PublishedClaim(
        "best_with_max",
        "Best participant: most with feedback",
        "1",
        Interval(0.0, 1.0),
        "1",
        "with",
        "count",
        FIGURE_3,
    ),
    PublishedClaim(
        "best_with_later",
        "Best participant: most from the second trial on, with feedback",
        "0",
        _count(0.0),
        "1",
        "with",
        "count",
        FIGURE_3,
    ),
    PublishedClaim(
        "worst_without_mean",
        "Worst participant: mean without feedback",
        "approximately 83",
        _about(83.0),
        "1",
        "without",
        "approximate",
        FIGURE_4,
        calibrated=True,
    ),
    PublishedClaim(
        "worst_without_first",
        "Worst participant: first trial without feedback",
        "124",
        _count(124.0),
        "1",
        "without",
        "count",
        FIGURE_4,
    ),
    PublishedClaim(
        "worst_without_last",
        "Worst participant: last trial without feedback",
        "around 60",
        _about(60.0),
        "1",
        "without",
        "approximate",
        FIGURE_4,
    ),
    PublishedClaim(
        "worst_with_mean",
        "Worst participant: mean with feedback",
        "approximately 7",
        _about(7.0),
        "1",
        "with",
        "approximate",
        FIGURE_4,
    ),
    PublishedClaim(
        "worst_with_first",
        "Worst participant: first trial with feedback",
        "11",
        _count(11.0),
        "1",
        "with",
        "count",
        FIGURE_4,
    ),
    PublishedClaim(
        "worst_with_last",
        "Worst participant: last trial with feedback",
        "4",
        _count(4.0),
        "1",
        "with",
        "count",
        FIGURE_4,
    ),
)
