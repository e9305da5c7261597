from __future__ import annotations

from collections import Counter

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from protocol_page import changed_protocol

from omnistudy.protocol import Protocol, plan
from omnistudy.protocol.compose import compose_protocol
from omnistudy.protocol.plan import shuffled_routes


def test_a_slot_plans_ten_trials_with_repetitions_counted(component: Protocol) -> None:
    trials = plan(component, 0)
    assert [trial.position for trial in trials] == list(range(1, 11))
    assert [(trial.condition, trial.repetition) for trial in trials[:7]] == [
        ("none", 1),
        ("none", 2),
        ("none", 3),
        ("full", 1),
        ("full", 2),
        ("full", 3),
        ("centre_front_10", 1),
    ]
    assert {trial.kind for trial in trials} == {"main"}


def test_in_ten_trials_each_route_comes_three_or_four_times(component: Protocol) -> None:
    total: Counter[str] = Counter()
    for slot in range(60):
        counts = Counter(trial.route for trial in plan(component, slot))
        assert sorted(counts.values()) == [3, 3, 4]
        total += counts
    assert set(total.values()) == {200}


def test_the_plan_is_the_same_every_time(component: Protocol) -> None:
    again = compose_protocol("utah2017_component")
    assert all(plan(component, slot) == plan(again, slot) for slot in range(8))


def test_routes_differ_from_slot_to_slot(component: Protocol) -> None:
    routes = {tuple(trial.route for trial in plan(component, slot)) for slot in range(20)}
    assert len(routes) >= 19


def test_another_number_of_participants_moves_no_conditions(component: Protocol) -> None:
    fewer = changed_protocol("participants.count=2")
    for slot in range(2):
        assert [trial.condition for trial in plan(component, slot)] == [
            trial.condition for trial in plan(fewer, slot)
        ]


def test_mending_a_text_redraws_nothing(component: Protocol) -> None:
    mended = changed_protocol("title=Mended")
    assert all(plan(component, slot) == plan(mended, slot) for slot in range(8))


@given(st.integers(1, 6), st.integers(1, 30), st.integers(0, 20), st.integers(0, 2**32))
def test_routes_are_spread_evenly(routes: int, trials: int, slot: int, seed: int) -> None:
    names = [f"r{index}" for index in range(routes)]
    drawn = shuffled_routes(names, trials, slot, np.random.default_rng(seed))
    counts = Counter(dict.fromkeys(names, 0)) + Counter(drawn)
    numbers = [counts[name] for name in names]
    assert len(drawn) == trials
    assert max(numbers) - min(numbers) <= 1
