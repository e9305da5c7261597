from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from protocol_page import changed_protocol

from omnistudy.protocol import Protocol, StudyPlan, plan
from omnistudy.protocol.compose import compose_protocol
from omnistudy.protocol.ordering.order import PastTrial
from omnistudy.protocol.plan import catch_places
from omnistudy.protocol.routes import spread_routes


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


def test_in_ten_trials_each_route_comes_three_or_four_times() -> None:
    component = changed_protocol("participants.count=60")
    total: Counter[str] = Counter()
    each: Counter[tuple[str | None, str]] = Counter()
    study = StudyPlan(component)
    for slot in range(60):
        trials = study.trials(slot)
        assert sorted(Counter(trial.route for trial in trials).values()) == [3, 3, 4]
        total.update(trial.route for trial in trials)
        each.update((trial.condition, trial.route) for trial in trials)
    assert set(total.values()) == {200}
    assert set(each.values()) == {60, 20}


def test_three_trials_of_a_condition_go_along_all_three_routes(component: Protocol) -> None:
    for slot in range(8):
        free = [trial.route for trial in plan(component, slot) if trial.condition == "none"]
        assert len(set(free)) == 3


def test_the_plan_is_the_same_every_time(component: Protocol) -> None:
    again = compose_protocol("utah2017_component")
    assert all(plan(component, slot) == plan(again, slot) for slot in range(8))


def test_routes_differ_from_slot_to_slot() -> None:
    study = StudyPlan(changed_protocol("participants.count=20"))
    routes = {tuple(trial.route for trial in study.trials(slot)) for slot in range(20)}
    assert len(routes) >= 15


def test_mending_a_text_redraws_nothing(component: Protocol) -> None:
    mended = changed_protocol("title=Mended")
    assert all(plan(component, slot) == plan(mended, slot) for slot in range(8))


def test_the_first_freeze_decides_even_if_the_protocol_reads_otherwise_today() -> None:
    component = compose_protocol("utah2017_williams")
    other = changed_protocol("plant.mass=25")
    assert StudyPlan(component, "0" * 64).allocations == StudyPlan(component, "0" * 64).allocations
    drawn = [StudyPlan(component, digit * 64).trials(0) for digit in "0123456789"]
    assert len(set(drawn)) == 10
    assert StudyPlan(other, "0" * 64).trials(3) == StudyPlan(other, "0" * 64).trials(3)


trials_met = st.lists(st.integers(1, 7), min_size=1, max_size=6)


@given(st.integers(1, 6), trials_met, st.integers(0, 20), st.integers(0, 2**32))
def test_routes_are_spread_evenly_over_a_participant_and_over_conditions(
    routes: int, repetitions: list[int], row: int, seed: int
) -> None:
    names = [f"r{index}" for index in range(routes)]
    conditions = [f"c{i}" for i, times in enumerate(repetitions) for _ in range(times)]
    drawn = spread_routes(names, conditions, row, np.random.default_rng(seed))
    met = Counter(zip(conditions, drawn, strict=True))
    for chosen in [set(conditions), *({one} for one in conditions)]:
        counts = [sum(met[one, name] for one in chosen) for name in names]
        assert max(counts) - min(counts) <= 1


@given(st.integers(2, 40), st.data())
def test_catch_trials_never_come_first_nor_together(trials: int, data: st.DataObject) -> None:
    catches = data.draw(st.integers(1, trials - 1))
    rng = np.random.default_rng(data.draw(st.integers(0, 2**32)))
    kinds = ["main"] * trials
    for place in catch_places(trials, catches, rng):
        kinds.insert(place, "catch")
    text = "".join("c" if kind == "catch" else "m" for kind in kinds)
    assert text.count("c") == catches
    assert text[0] == "m"
    assert text[-1] == "m"
    assert "cc" not in text


VISITS = (
    "~order",
    "visits=[{name: first, blocks: ["
    "{kind: practice, only: [{factor: feedback, level: without}], order: {kind: permuted_blocks}},"
    "{order: {kind: williams}, catch: {condition: none, trials: 2}}]},"
    "{name: later, days: {earliest: 6, latest: 8}, blocks: ["
    "{kind: retention, order: {kind: latin}, routes: [red-green-blue]}]}]",
)


def test_visits_have_blocks_of_several_kinds() -> None:
    trials = plan(changed_protocol(*VISITS), 0)
    assert [trial.position for trial in trials] == list(range(1, 16))
    assert [(trial.visit, trial.block) for trial in trials] == [(1, 0)] + [(1, 1)] * 8 + [
        (2, 2)
    ] * 6
    assert Counter(trial.kind for trial in trials) == {
        "practice": 1,
        "main": 6,
        "catch": 2,
        "retention": 6,
    }
    assert trials[0].condition == "none"
    assert {trial.condition for trial in trials if trial.kind == "catch"} == {"none"}
    assert {trial.repetition for trial in trials if trial.kind == "main"} == {1}
    assert {trial.route for trial in trials if trial.visit == 2} == {"red-green-blue"}


def test_an_order_that_adapts_is_asked_trial_by_trial() -> None:
    protocol = changed_protocol("order={kind: staircase, count: 4, start: full}")
    study = StudyPlan(protocol)
    assert [trial.condition for trial in study.trials(0)] == [None] * 4
    history: list[PastTrial] = []
    assert study.next_condition(0, 0, history) == "full"
    history.append(PastTrial("full", "completed", 60.0, 3))
    assert study.next_condition(0, 0, history) == "none"


@pytest.mark.parametrize("slot", range(24))
def test_in_a_mixed_design_everybody_stays_in_one_group(slot: int) -> None:
    protocol = compose_protocol("mixed_2x3")
    met = {protocol.condition(str(one.condition)).levels[0].level for one in plan(protocol, slot)}
    assert len(met) == 1
