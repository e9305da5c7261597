"""Rankings of tables made by hand."""

from __future__ import annotations

from itertools import product
from math import sqrt

import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from omnistudy.analysis.sweep import Ranking, not_dominated, rank, worst_tenth
from omnistudy.errors.sweep import NoCompletePoint, ObjectiveNotRecorded, UnknownOutcome

PEOPLE = ("P01", "P02", "P03", "P04")


def table(
    collisions: dict[int, list[list[float]]], duration: float = 100.0, work: float = 5.0
) -> pd.DataFrame:
    """Give one trial a row: collisions[design][nuisance][participant]."""
    return pd.DataFrame(
        [
            {
                "design": design,
                "nuisance": nuisance,
                "gain": 10.0 * design,
                "participant": PEOPLE[person],
                "status": "completed",
                "collisions": value,
                "duration_s": duration,
                "work_against_j": work,
            }
            for design, cells in collisions.items()
            for nuisance, people in enumerate(cells, start=1)
            for person, value in enumerate(people)
        ]
    )


THREE = table(
    {
        1: [[4, 6, 8, 10], [8, 10, 12, 14]],
        2: [[1, 2, 3, 4], [2, 3, 4, 7]],
        3: [[1, 2, 3, 5], [3, 2, 5, 6]],
    }
)


def ranked(rows: pd.DataFrame, nuisances: int = 2, **how: object) -> Ranking:
    return rank(rows, ["gain"], nuisances, "seed", **how)  # type: ignore[arg-type]


def test_the_best_mean_comes_first() -> None:
    ranking = ranked(THREE)
    assert [point.row for point in ranking.points] == [2, 3, 1]
    assert [point.values for point in ranking.points] == [(20.0,), (30.0,), (10.0,)]
    assert [point.mean.value for point in ranking.points] == [26 / 8, 27 / 8, 72 / 8]


def test_the_interval_of_a_mean_is_students_over_participants() -> None:
    """Participants' own means at design 1 are 6, 8, 10, 12."""
    (point,) = (point for point in ranked(THREE).points if point.row == 1)
    reach = stats.t.ppf(0.975, 3) * sqrt(20 / 3) / sqrt(4)
    assert point.mean.interval.low == pytest.approx(9 - reach, rel=0.03)
    assert point.mean.interval.high == pytest.approx(9 + reach, rel=0.03)


def test_differences_are_paired_and_corrected() -> None:
    """Behind the best by 4.5, 5.5, 6.5, 6.5: clearly, though the people differ much more."""
    (point,) = (point for point in ranked(THREE).points if point.row == 1)
    differences = np.array([4.5, 5.5, 6.5, 6.5])
    reach = stats.t.ppf(1 - 0.05 / 4, 3) * differences.std(ddof=1) / 2
    assert point.behind.value == 5.75
    assert point.behind.interval.low == pytest.approx(5.75 - reach, rel=0.05)
    assert not point.tied


def test_what_is_hardly_behind_cannot_be_told_apart() -> None:
    tied = {point.row for point in ranked(THREE).points if point.tied}
    assert tied == {2, 3}


def test_participants_who_are_all_alike_show_no_spread_and_tell_nothing_apart() -> None:
    points = ranked(table({1: [[1, 1, 1, 1]], 2: [[3, 3, 3, 3]]}), nuisances=1).points
    assert [point.tied for point in points] == [True, True]
    assert not points[1].behind.interval.known
    alone = ranked(table({1: [[1]], 2: [[3]]}), nuisances=1)
    assert alone.participants == 1
    assert [point.mean.interval.known for point in alone.points] == [False, False]


def test_the_worst_tenth_can_turn_the_ranking_round() -> None:
    """Design 1 is better on the whole but fails at one of ten arms."""
    steady = [[3, 3, 3, 4]] * 10
    fragile = [[1, 1, 1, 2]] * 9 + [[9, 9, 9, 12]]
    rows = table({1: fragile, 2: steady})
    assert [point.row for point in ranked(rows, 10).points] == [1, 2]
    worst = ranked(rows, 10, order="worst_tenth").points
    assert [point.row for point in worst] == [2, 1]
    assert [point.worst_tenth.value for point in worst] == [13 / 4, 39 / 4]


def test_the_worst_tenth_of_few_is_the_worst() -> None:
    assert worst_tenth(np.array([[1.0], [7.0], [3.0]])) == [7.0]
    assert worst_tenth(np.arange(20.0)[:, None]) == [18.5]


def test_points_that_did_not_meet_all_of_the_nuisance_are_left_out() -> None:
    rows = THREE[~((THREE["design"] == 2) & (THREE["nuisance"] == 2))]
    ranking = ranked(rows)
    assert [point.row for point in ranking.points] == [3, 1]
    assert ranking.left_out == (2,)
    with pytest.raises(NoCompletePoint, match="all 3 nuisance points"):
        ranked(THREE, nuisances=3)


def test_late_trials_are_counted_beside_what_they_came_to() -> None:
    rows = THREE.assign(status=["timed_out"] + ["completed"] * 23)
    late = {point.row: point.timed_out for point in ranked(rows).points}
    assert late == {1: 1 / 8, 2: 0.0, 3: 0.0}


def test_an_outcome_that_is_missing_is_said() -> None:
    rows = THREE.assign(work_against_j=float("nan"))
    assert ranked(rows).points[0].in_front
    with pytest.raises(ObjectiveNotRecorded, match="work_against_j is not recorded"):
        ranked(rows, by="work_against_j")
    with pytest.raises(UnknownOutcome, match="did you mean 'collisions'"):
        ranked(rows, by="colisions")


def test_same_seed_same_intervals() -> None:
    assert ranked(THREE) == ranked(THREE)


def test_the_front_of_three_outcomes() -> None:
    outcomes = np.array([[1, 5, 5], [2, 4, 5], [2, 5, 5], [1, 5, 5], [9, 9, 1]], dtype=np.float64)
    assert not_dominated(outcomes).tolist() == [True, True, False, True, True]


@given(st.lists(st.tuples(*[st.integers(0, 4)] * 3), min_size=1, max_size=12))
def test_every_dominated_point_is_dominated_by_one_of_the_front(
    points: list[tuple[int, int, int]],
) -> None:
    front = not_dominated(np.array(points, dtype=np.float64))
    for (place, point), other in product(enumerate(points), points):
        if front[place]:
            assert other == point or any(b > a for a, b in zip(point, other, strict=True))
    for place, point in enumerate(points):
        beaten_by = [
            other
            for other, kept in zip(points, front, strict=True)
            if kept and all(b <= a for a, b in zip(point, other, strict=True)) and other != point
        ]
        assert front[place] or beaten_by
