"""Orders that adapt, several visits, and the check that what runs is what was planned."""

from __future__ import annotations

import sqlite3
from collections import Counter
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest
from protocol_page import changed_protocol

import omnistudy
from omnistudy.errors.study import OrderDiffers
from omnistudy.protocol import Protocol, StudyPlan
from omnistudy.protocol.ordering.order import PastTrial, Seat
from omnistudy.protocol.ordering.staircase import Staircase
from omnistudy.session import run_trials
from omnistudy.store import StudyWriter, sample_digest
from omnistudy.study import OrderCheck, create_study

QUICK = (
    "task.time_limit=0.05",
    "participants.count=2",
    "routes=[red-green-blue]",
)
"""Every trial is over after a few simulated seconds: what counts here is the order."""


@pytest.fixture(scope="module")
def staircase() -> Protocol:
    return changed_protocol(*QUICK, "order={kind: staircase, count: 4, start: centre_front_20}")


def test_a_staircase_chooses_each_trial_from_what_came_before(
    staircase: Protocol, tmp_path: Path
) -> None:
    path = tmp_path / "stairs.db"
    create_study(staircase, path, "stairs")
    run_trials(path)
    names = [condition.name for condition in staircase.conditions]
    with omnistudy.open(path) as study:
        trials = study.trials()
    assert len(trials) == 8
    for _, own in trials.groupby("participant"):
        history: list[PastTrial] = []
        seen: Counter[str] = Counter()
        for row in own.itertuples():
            assert isinstance(staircase.order, Staircase)
            assert row.condition == staircase.order.next(names, Seat(0, ""), history)
            seen[row.condition] += 1
            assert row.repetition == seen[row.condition]
            history.append(PastTrial(row.condition, row.status, 1.0, int(row.collisions)))
    # Nobody reaches the finish in so short a time, so every trial fails and the next is easier.
    first = trials[trials["participant"] == "P01"]["condition"]
    assert list(first) == ["centre_front_20", "centre_front_10", "full", "none"]


def test_a_repeated_trial_is_chosen_as_if_nothing_came_after_it(
    staircase: Protocol, tmp_path: Path
) -> None:
    path = tmp_path / "stairs.db"
    record = create_study(staircase, path, "stairs")
    with StudyWriter.open(path) as writer:
        planned = writer.trials("P01")
    ended = [
        replace(trial, condition=name, status="completed", duration_s=60.0, collisions=count)
        for trial, name, count in zip(planned, ("centre_front_20",) * 4, (0, 9, 9, 9), strict=True)
    ]
    order = OrderCheck("stairs", staircase, record.design_hash)
    assert order.chosen(planned[1], ended) == "centre_front_20"
    assert order.chosen(planned[2], ended) == "centre_front_10"


@pytest.mark.slow
def test_a_staircase_is_the_same_with_two_workers_and_after_a_stop(
    staircase: Protocol, tmp_path: Path
) -> None:
    digests = set()
    for name, limits in {"one": (None,), "two": (None,), "stopped": (3, None)}.items():
        path = tmp_path / f"{name}.db"
        create_study(staircase, path, "stairs")
        for limit in limits:
            run_trials(path, workers=2 if name == "two" else 1, limit=limit)
        digests.add(sample_digest(path))
    assert len(digests) == 1


@pytest.mark.slow
def test_visits_are_sessions_of_their_own_and_practice_goes_on(tmp_path: Path) -> None:
    protocol = changed_protocol(
        *QUICK,
        "~order",
        "visits=[{name: first, blocks: [{kind: practice, order: {kind: latin}}]},"
        "{name: later, days: {earliest: 6, latest: 8}, blocks: [{order: {kind: williams}}]}]",
    )
    path = tmp_path / "visits.db"
    create_study(protocol, path, "visits")
    run_trials(path, limit=6)
    with omnistudy.open(path) as study:
        assert list(study.sessions()["status"]) == ["completed", "planned", "planned", "planned"]
        assert list(study.participants()["status"]) == ["active", "enrolled"]
    run_trials(path)
    with omnistudy.open(path) as study:
        trials, sessions = study.trials(), study.sessions()
        assert set(study.participants()["status"]) == {"completed"}
    assert list(sessions["visit"]) == [1, 2, 1, 2]
    assert set(sessions["status"]) == {"completed"}
    for _, own in trials.groupby("participant"):
        assert list(own["position"]) == list(range(1, 13))
        assert list(own["visit"]) == [1] * 6 + [2] * 6
        assert list(own["kind"]) == ["practice"] * 6 + ["main"] * 6
        assert own["started_at"].is_monotonic_increasing


@pytest.mark.parametrize(
    "change",
    [
        "UPDATE trial SET condition = 'full' WHERE id = 1",
        "UPDATE trial SET route = 'blue-green-red' WHERE id = 12",
        "UPDATE trial SET kind = 'catch' WHERE id = 3",
        "UPDATE trial SET repetition = 2 WHERE id = 1",
        "UPDATE trial SET position = 99 WHERE id = 10",
    ],
)
def test_a_study_whose_order_was_changed_is_not_run(change: str, tmp_path: Path) -> None:
    path = tmp_path / "changed.db"
    create_study(changed_protocol(*QUICK), path, "changed")
    with closing(sqlite3.connect(path)) as database, database:
        database.execute(change)
    with pytest.raises(OrderDiffers, match=r"trial \d+ of P0[12] is not the one"):
        run_trials(path, limit=1)
    with omnistudy.open(path) as study:
        assert set(study.trials()["status"]) == {"planned"}


def test_the_stored_allocation_is_the_one_of_the_plan(tmp_path: Path) -> None:
    from omnistudy.protocol.compose import compose_protocol

    protocol = compose_protocol("mixed_2x3")
    path = tmp_path / "mixed.db"
    record = create_study(protocol, path, "mixed")
    plan = StudyPlan(protocol, record.design_hash)
    with omnistudy.open(path) as study:
        stored, people, trials = study.allocations(), study.participants(), study.trials()
    columns = ["slot", "stratum", "group", "row"]
    assert [tuple(row) for row in stored[columns].itertuples(index=False)] == list(plan.allocations)
    assert list(stored["participant"]) == list(people["participant"])
    assert list(people["group"]) == list(stored["group"])
    assert list(people["sequence"]) == [str(row) for row in stored["row"]]
    assert Counter(trials["kind"]) == {"practice": 24, "main": 72, "retention": 72}
    for allocation in plan.allocations:
        own = trials[trials["participant"] == f"P{allocation.slot + 1:02d}"]
        planned = plan.trials(allocation.slot)
        assert list(own["condition"]) == [trial.condition for trial in planned]
        assert list(own["route"]) == [trial.route for trial in planned]
        assert list(own["visit"]) == [trial.visit for trial in planned]
        assert set(own["torque"]) == {allocation.group}
