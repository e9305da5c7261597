"""A design that cannot be run is told in one sentence: where, what was given, what to do."""

from __future__ import annotations

import pytest

from omnistudy.errors.protocol import ProtocolFaults
from omnistudy.protocol.compose import compose_protocol

LEARNING = "visits.learning.blocks"


def faults(*changes: str) -> tuple[str, ...]:
    with pytest.raises(ProtocolFaults) as caught:
        compose_protocol("mixed_2x3", changes)
    return caught.value.faults


@pytest.mark.parametrize(
    ("change", "beginning", "end"),
    [
        (
            "participants.count=1",
            "participants.count: 1 cannot fill 2 groups (with, without): the design cannot balance",
            "give at least 2",
        ),
        (
            "participants.strata={young: 23, old: 1}",
            "participants.strata.old.count: 1 cannot fill 2 groups",
            "give at least 2",
        ),
        (
            "participants.strata={young: 20, old: 3}",
            "participants.strata: their counts make 23, but participants.count is 24",
            "make them agree",
        ),
        (
            "visits.retention.days={earliest: 8, latest: 6}",
            "visits.retention.days: given",
            "latest must not be before earliest",
        ),
        (
            "+visits.learning.days={earliest: 1, latest: 2}",
            "visits.learning.days: days count from the first visit",
            "which has none",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: latin}}, only: {{layr: wide}}}}]",
            f"{LEARNING}.1.only.layr: unknown factor: the factors are torque, layer",
            "did you mean 'layer'?",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: latin}}, only: {{layer: wid}}}}]",
            f"{LEARNING}.1.only.layer: unknown level 'wid'",
            "did you mean 'wide'?",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: latin}}, only: {{layer: wide}}}}]",
            f"{LEARNING}.1.order: 'latin' cannot balance a single condition (with_wide)",
            "(of group 'with')",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: latin}}, catch: {{condition: with_wid}}}}]",
            f"{LEARNING}.1.catch.condition: unknown condition 'with_wid'",
            "did you mean 'with_wide'?",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: latin}}, catch: {{condition: with_wide, trials: 3}}}}]",
            f"{LEARNING}.1.catch.trials: 3 catch trials do not fit between 3 trials",
            "at most 2",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: staircase, count: 3, start: with_wide}}}}]",
            f"{LEARNING}.1.order: unknown condition 'with_wide' to start with",
            "(of group 'without')",
        ),
        (
            "order={kind: latin}",
            "order: both are given",
            "orders of their own",
        ),
        (
            "~visits",
            "order: neither is given",
            "orders of their own",
        ),
        (
            f"{LEARNING}=[{{order: {{kind: latin}}, routes: [red-gren-blue]}}]",
            "routes: world 'utah2017' has no route 'red-gren-blue'",
            "'red-green-blue'?",
        ),
        (
            "factors.layer.levels.wide={law: componnt}",
            "law: given 'componnt', but there is no such page",
            "did you mean 'component'?",
        ),
        (
            "factors.layer.levels.wide={lw: component}",
            "conditions.with_wide.lw: unknown key",
            "did you mean 'law'?",
        ),
        (
            "factors.torque.vary=sometimes",
            "factors.torque.vary: given 'sometimes'",
            "it should be 'within' or 'between'",
        ),
    ],
)
def test_each_fault_says_where_what_and_what_is_allowed(
    change: str, beginning: str, end: str
) -> None:
    first = faults(change)[0]
    assert first.startswith(beginning)
    assert first.endswith(end)


def test_levels_that_change_nothing_are_told() -> None:
    (fault,) = faults("~factors.torque.levels.without.law")
    assert fault.startswith("factors.torque: levels 'with' and 'without' have the same set-up")
    assert fault.endswith("or take the factor out")


def test_one_of_three_levels_that_changes_nothing_is_told_too() -> None:
    (fault,) = faults("~factors.layer.levels.wide.law")
    assert fault.startswith("factors.layer: levels 'published' and 'wide' have the same set-up")


def test_a_condition_that_nobody_meets_is_told() -> None:
    only = "[{order: {kind: permuted_blocks}, only: {layer: wide}}]"
    found = faults(f"{LEARNING}={only}", f"visits.retention.blocks={only}")
    assert [fault.split("'")[1] for fault in found] == [
        *("with_narrow", "with_published", "without_narrow", "without_published"),
    ]


def test_visits_may_not_come_before_the_one_before_them() -> None:
    days = "days: {earliest: 1, latest: 2}"
    found = faults(f"+visits.later={{{days}, blocks: [{{order: {{kind: latin}}}}]}}")
    assert found[0].startswith("visits.later.days: latest day 2 is before day 6")
