"""Whole designs counted at their own sizes, and held against an independent tool."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from protocol_page import changed_protocol

from omnistudy.protocol import StudyPlan
from omnistudy.protocol.balance import balance
from omnistudy.protocol.compose import compose_protocol
from omnistudy.protocol.ordering.latin import Latin
from omnistudy.protocol.ordering.order import Order
from omnistudy.protocol.ordering.williams import Williams


def test_a_published_design_balances_at_multiples_of_two_blocks_and_three_routes() -> None:
    found = balance(changed_protocol())
    assert found.multiple == 6
    assert found.losses == ("a condition meets a route 2 to 3 times",)
    assert balance(changed_protocol("participants.count=6")).losses == ()


@pytest.mark.parametrize("count", range(1, 25))
def test_a_design_is_even_exactly_at_its_multiples(count: int) -> None:
    found = balance(compose_protocol("utah2017_williams", [f"participants.count={count}"]))
    assert found.multiple == 6
    assert (found.losses == ()) is (count % 6 == 0)


def test_the_mixed_example_is_even_at_twelve_and_says_what_is_lost_at_fourteen() -> None:
    assert balance(compose_protocol("mixed_2x3", ["participants.count=12"])).losses == ()
    found = balance(compose_protocol("mixed_2x3", ["participants.count=14"]))
    assert found.multiple == 12
    assert "with, block 2: a condition stands 2 to 3 times in a place" in found.losses
    uneven = balance(compose_protocol("mixed_2x3", ["participants.count=13"]))
    assert "a group has 6 to 7 participants" in uneven.losses


def test_a_stratum_is_told_by_name() -> None:
    strata = "participants.strata={young: 12, old: 6}"
    found = balance(compose_protocol("mixed_2x3", [strata, "participants.count=18"]))
    assert found.participants == (12, 6)
    assert all(loss.startswith("old ") for loss in found.losses)
    assert found.losses


def test_an_order_that_adapts_promises_nothing() -> None:
    found = balance(changed_protocol("order={kind: staircase, count: 4, start: full}"))
    assert found == (1, (8,), ())


def test_sweetpea_accepts_the_shipped_williams_design_and_refuses_a_latin_square() -> None:
    assert mismatch(rows_of(Williams())) == {}
    assert mismatch(rows_of(Latin())) == {"crossings": ["[Factor<pair>]"]}


def rows_of(order: Order) -> list[list[str]]:
    """Give six participants' rows of the shipped design, its order replaced."""
    shipped = compose_protocol("utah2017_williams")
    (visit,) = shipped.visits
    blocks = (visit.blocks[0], visit.blocks[1].model_copy(update={"order": order}))
    visits = (visit.model_copy(update={"blocks": blocks}),)
    study = StudyPlan(shipped.model_copy(update={"visits": visits}))
    return [
        [str(trial.condition) for trial in study.trials(slot) if trial.kind == "main"]
        for slot in range(6)
    ]


def mismatch(rows: list[list[str]]) -> object:
    """Let SweetPea say what is wrong with rows that should balance places and neighbours.

    Its crossings ask for every condition once in every place, and for every condition once after
    each other one and once in front.
    """
    from sweetpea import (
        DerivedLevel,
        Factor,
        MultiCrossBlock,
        Window,
        sample_mismatch_experiment,
    )

    names, places = sorted(rows[0]), [str(place) for place in range(len(rows[0]))]
    condition, place = Factor("condition", names), Factor("place", places)

    def neighbours(before: str, after: str) -> Callable[[Any, Any], bool]:
        if not before:
            return lambda met, at: at[0] == "0" and met[0] == after
        return lambda met, at: at[0] != "0" and (met[-1], met[0]) == (before, after)

    pairs = [(before, after) for before in ["", *names] for after in names if before != after]
    window = [Window(neighbours(*pair), [condition, place], 2, 1, 0) for pair in pairs]
    levels = [DerivedLevel(">".join(p), w) for p, w in zip(pairs, window, strict=True)]
    pair = Factor("pair", levels)
    crossings = [[condition, place], [pair]]
    block = MultiCrossBlock([condition, place, pair], crossings, [])
    met = [f"{b}>{a}" for row in rows for b, a in zip(["", *row], row, strict=False)]
    sample = {
        "condition": [name for row in rows for name in row],
        "place": places * len(rows),
        "pair": met,
    }
    return sample_mismatch_experiment(block, sample)
