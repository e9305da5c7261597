"""Numbers of the report against small tables that are worked out by hand."""

from __future__ import annotations

from itertools import product
from math import isnan, sqrt

import numpy as np
import pandas as pd
import pytest
from synthetic_study import Synthetic

from omnistudy.analysis.arm_stiffness import arm_stiffness_curve
from omnistudy.analysis.comparison import OVER_DRAWS, OVER_PRIOR, compare
from omnistudy.analysis.counting import count_attempts, counted
from omnistudy.analysis.estimate import UNKNOWN, Interval, estimate
from omnistudy.analysis.outcomes import Place, collisions, completion_times
from omnistudy.analysis.published_utah2017 import CLAIMS
from omnistudy.analysis.report import analyse
from omnistudy.analysis.sign_flip import sign_flip
from omnistudy.errors.analysis import MixedKinds, NotAnArmStudy


def trials(*rows: tuple[str, int, str, int, str, float, int]) -> pd.DataFrame:
    """participant, position, condition, repetition, status, duration in s, collisions."""
    names = ["participant", "position", "condition", "repetition", "status", "duration_s", "n"]
    frame = pd.DataFrame(list(rows), columns=names)
    return frame.assign(visit=1, attempt=1)


TWO_PEOPLE = trials(
    ("P01", 1, "none", 1, "completed", 100.0, 30),
    ("P01", 2, "full", 1, "completed", 90.0, 2),
    ("P02", 1, "none", 1, "completed", 120.0, 40),
    ("P02", 2, "full", 1, "timed_out", 300.0, 6),
)


def test_mean_and_sample_standard_deviation() -> None:
    found = estimate([2.0, 4.0, 9.0, np.nan], "1")
    assert (found.mean, found.n) == (5.0, 3)
    assert found.sd == pytest.approx(sqrt((9 + 1 + 16) / 2))
    assert isnan(estimate([], "1").mean)
    assert isnan(estimate([3.0], "1").sd)


def test_collisions_count_trials_out_of_time_and_times_do_not() -> None:
    places = (Place("without", "none"), Place("with", "full"))
    counts = collisions(TWO_PEOPLE, places, "n")
    assert [bar.estimate.mean for bar in counts.bars] == [35.0, 4.0]
    times = completion_times(TWO_PEOPLE, places)
    assert [bar.estimate.mean for bar in times.bars] == [110.0, 90.0]
    assert times.left_out == 1


def test_of_a_repeated_trial_the_last_attempt_that_ran_counts() -> None:
    repeated = pd.concat([TWO_PEOPLE, TWO_PEOPLE.head(1).assign(attempt=2, n=10)])
    voided = repeated.copy()
    assert counted(repeated)["n"].tolist() == [10, 2, 40, 6]
    voided.iloc[-1, voided.columns.get_loc("status")] = "void"
    assert counted(voided)["n"].tolist() == [30, 2, 40, 6]
    (none, full) = count_attempts(voided, ("none", "full"))
    assert (none.of("completed"), none.of("void"), full.of("timed_out")) == (2, 1, 1)


def test_intervals_meet_at_their_ends_and_an_unknown_one_never() -> None:
    assert Interval(1.0, 2.0).meets(Interval(2.0, 3.0))
    assert not Interval(1.0, 2.0).meets(Interval(2.1, 3.0))
    assert not UNKNOWN.known
    assert not UNKNOWN.meets(Interval(0.0, 1.0))


def test_sign_flip_agrees_with_every_pattern_written_out() -> None:
    differences = np.array([3.0, -1.0, 2.0, 4.0])
    sums = [
        abs(sum(sign * value for sign, value in zip(signs, differences, strict=True)))
        for signs in product((1, -1), repeat=4)
    ]
    by_hand = sum(value >= 8.0 for value in sums) / 16
    assert sign_flip(differences, "s").p == by_hand == 0.25
    assert sign_flip(np.full(8, 5.0), "s").p == pytest.approx(2 / 2**8)  # 0.0078


def test_sign_flip_of_many_pairs_is_drawn_from_the_seed_and_near_the_exact_one() -> None:
    rng = np.random.Generator(np.random.PCG64(1))
    many = rng.normal(0.4, 1.0, 20)
    first, again = sign_flip(many, "a"), sign_flip(many, "a")
    assert first == again
    z = many.mean() / (np.sqrt((many**2).mean()) / np.sqrt(20))
    normal = float(np.vectorize(lambda v: 2 * (1 - 0.5 * (1 + _erf(v / sqrt(2)))))(z))
    assert first.p == pytest.approx(normal, abs=0.03)


def _erf(value: float) -> float:
    from math import erf

    return erf(value)


def test_curve_over_the_prior_has_a_mean_a_quantile(synthetic: Synthetic) -> None:
    arms = synthetic.arms()
    curve = arm_stiffness_curve(arms, "collisions")
    assert [point.quantile for point in curve.points] == [0.05, 0.25, 0.5, 0.75, 0.95]
    for point in curve.points:
        own = arms.trials[arms.trials["condition"] == point.condition]["collisions"]
        assert point.collisions.mean == pytest.approx(own.mean())
    assert len(curve.lines) == 8
    with pytest.raises(NotAnArmStudy):
        arm_stiffness_curve(synthetic.published(), "collisions")


def test_curve_counts_who_ran_out_of_time(synthetic: Synthetic) -> None:
    arms = synthetic.arms()
    arms.trials.loc[arms.trials.index[:1], "status"] = "timed_out"
    curve = arm_stiffness_curve(arms, "collisions")
    assert [point.timed_out for point in curve.points] == [1, 0, 0, 0, 0]
    assert [point.collisions.n for point in curve.points] == [8] * 5


def test_every_claim_has_a_row_and_what_was_calibrated_is_called_so(synthetic: Synthetic) -> None:
    rows = {
        row.claim.key: row
        for row in compare(synthetic.published(), synthetic.arms(), "collisions_legacy")
    }
    assert set(rows) == {claim.key for claim in CLAIMS}
    calibrated = {key for key, row in rows.items() if row.verdict == "calibrated"}
    assert calibrated == {"mean_without", "best_without_mean", "worst_without_mean"}


@pytest.mark.slow
def test_numbers_with_feedback_are_intervals_over_the_prior_never_points(
    synthetic: Synthetic,
) -> None:
    published, arms = synthetic.published(), synthetic.arms()
    (row,) = [r for r in compare(published, arms, "collisions") if r.claim.key == "mean_with"]
    means = arms.trials.groupby("condition")["collisions"].mean()
    assert row.point is None
    assert (row.interval.low, row.interval.high) == pytest.approx((means.min(), means.max()))
    for row in compare(published, arms, "collisions"):
        assert (row.point is None) == (row.claim.arm != "without")


def test_what_speaks_of_three_trials_is_never_computed_from_the_one_of_the_arm_study(
    synthetic: Synthetic,
) -> None:
    rows = {
        row.claim.key: row
        for row in compare(synthetic.published(), synthetic.arms(), "collisions_legacy")
    }
    for key in ("best_with_max", "best_with_later", "worst_with_first", "worst_with_last"):
        assert rows[key].method == OVER_DRAWS
    for key in ("mean_with", "worst_with_mean", "time_ratio"):
        assert rows[key].method == OVER_PRIOR


def test_a_group_without_a_collision_misses_what_the_driver_was_calibrated_on(
    synthetic: Synthetic,
) -> None:
    nobody = synthetic.published()
    nobody.trials["collisions"] = 0
    rows = {row.claim.key: row for row in compare(nobody, None, "collisions")}
    calibrated = rows["mean_without"]
    assert (calibrated.point, calibrated.interval) == (0.0, Interval(0.0, 0.0))
    assert (calibrated.verdict, calibrated.agrees) == ("calibrated", False)
    assert rows["third_without"].verdict == "miss"
    assert rows["best_with_max"].verdict == "hit"
    assert rows["learning_without"].verdict == "open", "nothing over nothing"


def test_a_verdict_is_a_hit_only_when_the_intervals_meet(synthetic: Synthetic) -> None:
    for row in compare(synthetic.published(), synthetic.arms(), "collisions"):
        if row.verdict in ("hit", "miss"):
            assert (row.verdict == "hit") == row.interval.meets(row.claim.reads_as)


def test_without_the_arm_study_a_p_stays_open(synthetic: Synthetic) -> None:
    rows = {r.claim.key: r for r in compare(synthetic.published(), None, "collisions")}
    assert rows["p_collisions"].verdict == "open"
    assert rows["mean_with"].interval.known


def test_humans_and_virtual_people_are_never_mixed(synthetic: Synthetic) -> None:
    tables = synthetic.published(2)
    tables.participants.loc[0, "kind"] = "human"
    with pytest.raises(MixedKinds):
        analyse(tables)


def test_a_study_of_one_person_and_one_of_nobody_are_analysed(synthetic: Synthetic) -> None:
    alone = analyse(synthetic.published(1))
    assert alone.best is not None
    assert alone.best.participant == "P01"
    published = synthetic.published(2)
    planned = analyse(
        synthetic.tables(
            "planned",
            [(*row[:8], "planned", np.nan, np.nan, np.nan) for row in _rows(published.trials)],
            published.conditions,
        )
    )
    assert all(bar.estimate.n == 0 for bar in planned.collisions.bars)


def _rows(frame: pd.DataFrame) -> list[tuple[object, ...]]:
    return [tuple(row) for row in frame.itertuples(index=False)]
