from __future__ import annotations

from collections import Counter

from hypothesis import given
from hypothesis import strategies as st
from protocol_page import changed_protocol

from omnistudy.protocol.allocation import allocations
from omnistudy.protocol.compose import compose_protocol

MIXED = compose_protocol("mixed_2x3")


@given(st.text(), st.integers(2, 40))
def test_groups_are_dealt_out_in_blocks_and_rows_counted_inside_them(
    design: str, count: int
) -> None:
    people = MIXED.participants.model_copy(update={"count": count})
    found = allocations(MIXED.model_copy(update={"participants": people}), design)
    assert [one.slot for one in found] == list(range(count))
    sizes = Counter(one.group for one in found)
    assert max(sizes.values()) - min(sizes.values()) <= count % 2
    for group in sizes:
        assert [one.row for one in found if one.group == group] == list(range(sizes[group]))
    for start in range(0, count - 3, 4):
        assert Counter(one.group for one in found[start : start + 4]) == {"with": 2, "without": 2}


def test_groups_are_drawn_from_the_design_hash_alone() -> None:
    drawn = {tuple(one.group for one in allocations(MIXED, str(seed))) for seed in range(20)}
    assert len(drawn) == 20
    assert allocations(MIXED, "a") == allocations(MIXED, "a")


def test_strata_follow_each_other_and_are_allocated_each_by_itself() -> None:
    people = MIXED.participants.model_validate(
        MIXED.participants.model_dump()
        | {"count": 12, "strata": [{"name": "new", "count": 8}, {"name": "gamer", "count": 4}]}
    )
    found = allocations(MIXED.model_copy(update={"participants": people}), "design")
    assert [one.stratum for one in found] == ["new"] * 8 + ["gamer"] * 4
    cells = Counter((one.stratum, one.group) for one in found)
    assert cells == {
        ("new", "with"): 4,
        ("new", "without"): 4,
        ("gamer", "with"): 2,
        ("gamer", "without"): 2,
    }
    for cell in cells:
        rows = [one.row for one in found if (one.stratum, one.group) == cell]
        assert rows == list(range(cells[cell]))


def test_with_one_group_slots_are_rows() -> None:
    found = allocations(changed_protocol(), "design")
    assert [tuple(one) for one in found] == [(slot, "", "", slot) for slot in range(8)]
