"""What orders promise, counted over every design of up to twelve conditions."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise, permutations
from math import lcm

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.protocol.ordering.latin import Latin
from omnistudy.protocol.ordering.order import PastTrial, PlannedOrder, Seat
from omnistudy.protocol.ordering.permuted_blocks import PermutedBlocks
from omnistudy.protocol.ordering.published_blocks import PublishedBlocks
from omnistudy.protocol.ordering.staircase import Staircase
from omnistudy.protocol.ordering.williams import Williams
from omnistudy.protocol.routes import spread_routes

LAST = ("centre_front_10", "centre_front_20", "centre_rear_10", "zero_torque")
PUBLISHED = PublishedBlocks(blocks=("none", "full"), last=LAST)
SIZES = range(2, 13)
SEEDS = ("a", "b")


def names(size: int) -> list[str]:
    return [f"c{index}" for index in range(size)]


def rows(order: PlannedOrder, size: int, count: int, seed: str) -> list[tuple[str, ...]]:
    return [order.sequence(names(size), Seat(row, seed)) for row in range(count)]


def in_places(lines: list[tuple[str, ...]]) -> set[int]:
    """How often each condition stands in each place: one number when that is even."""
    counts = Counter((name, place) for line in lines for place, name in enumerate(line))
    return {counts[name, place] for name in lines[0] for place in range(len(lines[0]))}


def after_each_other(lines: list[tuple[str, ...]]) -> set[int]:
    counts = Counter(pair for line in lines for pair in pairwise(line))
    return {counts[pair] for pair in permutations(lines[0], 2)}


def test_the_published_order_is_that_of_the_thesis() -> None:
    assert PUBLISHED.sequence([], Seat(0, "")) == ("none",) * 3 + ("full",) * 3 + LAST
    assert PUBLISHED.sequence([], Seat(1, "")) == ("full",) * 3 + ("none",) * 3 + LAST


def test_published_blocks_alternate_from_seat_to_seat() -> None:
    firsts = [PUBLISHED.sequence([], Seat(row, ""))[0] for row in range(8)]
    assert firsts == ["none", "full"] * 4


@given(
    st.lists(st.text(min_size=1), min_size=1, max_size=4, unique=True),
    st.integers(1, 4),
    st.lists(st.text(), max_size=3),
    st.integers(0, 50),
)
def test_every_seat_meets_the_same_published_trials(
    blocks: list[str], length: int, last: list[str], row: int
) -> None:
    order = PublishedBlocks(blocks=tuple(blocks), block_length=length, last=tuple(last))
    found = order.sequence([], Seat(row, ""))
    assert Counter(found) == Counter(blocks * length + last)
    assert found[len(found) - len(last) :] == tuple(last)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("order", [Latin(), Williams()], ids=["latin", "williams"])
def test_over_its_period_a_square_has_every_condition_once_in_every_place(
    order: PlannedOrder, size: int, seed: str
) -> None:
    period = order.period(names(size))
    lines = rows(order, size, 2 * period, seed)
    assert len(set(lines[:period])) == period
    for run in (lines[:period], lines[period:]):
        assert in_places(run) == {period // size}
        assert order.imbalance(names(size), run) == ()


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("seed", SEEDS)
def test_in_williams_squares_each_condition_follows_each_other_equally_often(
    size: int, seed: str
) -> None:
    period = Williams().period(names(size))
    assert period == (size if size % 2 == 0 else 2 * size)
    assert after_each_other(rows(Williams(), size, period, seed)) == {period // size}


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("routes", [1, 2, 3, 4])
@pytest.mark.parametrize("order", [Latin(), Williams()], ids=["latin", "williams"])
def test_every_condition_meets_every_route_equally_often(
    order: PlannedOrder, routes: int, size: int
) -> None:
    count = lcm(order.period(names(size)), routes)
    met: Counter[tuple[str, str]] = Counter()
    for row, line in enumerate(rows(order, size, count, "seed")):
        drawn = spread_routes("abcd"[:routes], line, row, np.random.default_rng(row))
        met.update(zip(line, drawn, strict=True))
    assert len(met) == size * routes
    assert set(met.values()) == {count // routes}


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("order", [Latin(), Williams()], ids=["latin", "williams"])
def test_below_its_period_a_square_says_what_is_uneven(order: PlannedOrder, size: int) -> None:
    for count in range(1, order.period(names(size))):
        lines = rows(order, size, count, "seed")
        even = len(in_places(lines)) == 1
        if isinstance(order, Williams):
            even = even and len(after_each_other(lines)) == 1
        assert (order.imbalance(names(size), lines) == ()) is even


def test_a_cyclic_square_does_not_balance_what_follows_what() -> None:
    assert after_each_other(rows(Latin(), 4, 4, "seed")) == {0, 3}


def test_places_may_hold_several_trials_and_rows_be_repeated() -> None:
    order = Latin(block_length=2, repetitions=2)
    once = Latin().sequence(names(3), Seat(4, "seed"))
    doubled = tuple(name for name in once for _ in range(2))
    assert order.sequence(names(3), Seat(4, "seed")) == doubled * 2
    assert order.trials(names(3)) == 12
    assert order.imbalance(names(3), rows(order, 3, 3, "seed")) == ()


def test_rows_are_dealt_out_in_another_order_from_seed_to_seed() -> None:
    dealt = {tuple(rows(Williams(), 6, 6, str(seed))) for seed in range(20)}
    assert len(dealt) == 20


def test_every_run_of_seats_meets_the_rows_in_another_order() -> None:
    lines = rows(Latin(), 6, 60, "seed")
    runs = [tuple(lines[start : start + 6]) for start in range(0, 60, 6)]
    assert len(set(runs)) == 10
    assert len({frozenset(run) for run in runs}) == 1


@given(st.integers(1, 12), st.integers(1, 5), st.integers(0, 30), st.text())
def test_every_permuted_block_holds_every_condition_once(
    size: int, blocks: int, row: int, seed: str
) -> None:
    found = PermutedBlocks(blocks=blocks).sequence(names(size), Seat(row, seed))
    for start in range(0, len(found), size):
        assert sorted(found[start : start + size]) == sorted(names(size))
    assert len(found) == size * blocks


def test_permuted_blocks_differ_from_seat_to_seat() -> None:
    assert len(set(rows(PermutedBlocks(blocks=3), 5, 30, "seed"))) == 30


@pytest.mark.parametrize("order", [Latin(), Williams()], ids=["latin", "williams"])
def test_a_single_condition_cannot_be_balanced(order: PlannedOrder) -> None:
    (fault,) = order.faults(["only"])
    assert "cannot balance a single condition (only)" in fault
    assert "permuted_blocks" in fault


def walked(order: Staircase, collisions: list[int]) -> list[str | None]:
    history: list[PastTrial] = []
    for count in collisions:
        condition = order.next(names(4), Seat(0, ""), history)
        assert condition is not None
        history.append(PastTrial(condition, "completed", 60.0, count))
    return [trial.condition for trial in history]


def test_two_successes_go_up_and_one_failure_goes_down() -> None:
    order = Staircase(count=9, start="c1", most_collisions=1)
    assert walked(order, [0, 1, 0, 2, 0, 0, 0, 1, 5]) == [
        *("c1", "c1", "c2", "c2", "c1", "c1", "c2", "c2", "c3"),
    ]


def test_a_staircase_stays_between_its_ends_and_ends() -> None:
    order = Staircase(count=5, start="c0", harder_after=1)
    assert walked(order, [9, 9, 9, 9, 9]) == ["c0"] * 5
    assert walked(order, [0, 0, 0, 0, 0]) == ["c0", "c1", "c2", "c3", "c3"]
    over = [PastTrial("c0", "completed", 1.0, 0)] * 5
    assert order.next(names(4), Seat(0, ""), over) is None


def test_a_trial_out_of_time_is_no_success() -> None:
    order = Staircase(count=5, start="c1", harder_after=1)
    assert order.next(names(3), Seat(0, ""), [PastTrial("c1", "timed_out", 60.0, 0)]) == "c0"
