from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.protocol.ordering.published_blocks import PublishedBlocks
from omnistudy.protocol.ordering.rotated import Rotated

RNG = np.random.default_rng(0)
LAST = ("centre_front_10", "centre_front_20", "centre_rear_10", "zero_torque")
PUBLISHED = PublishedBlocks(blocks=("none", "full"), last=LAST)


def test_the_published_order_is_that_of_the_thesis() -> None:
    assert PUBLISHED.sequence([], 0, RNG) == ("none",) * 3 + ("full",) * 3 + LAST
    assert PUBLISHED.sequence([], 1, RNG) == ("full",) * 3 + ("none",) * 3 + LAST


def test_blocks_alternate_from_slot_to_slot() -> None:
    firsts = [PUBLISHED.sequence([], slot, RNG)[0] for slot in range(8)]
    assert firsts == ["none", "full"] * 4


@given(
    st.lists(st.text(min_size=1), min_size=1, max_size=4, unique=True),
    st.integers(1, 4),
    st.lists(st.text(), max_size=3),
    st.integers(0, 50),
)
def test_every_slot_meets_the_same_trials(
    blocks: list[str], length: int, last: list[str], slot: int
) -> None:
    order = PublishedBlocks(blocks=tuple(blocks), block_length=length, last=tuple(last))
    found = order.sequence([], slot, RNG)
    assert Counter(found) == Counter(blocks * length + last)
    assert found[len(found) - len(last) :] == tuple(last)


@pytest.mark.parametrize("conditions", range(1, 8))
def test_over_as_many_slots_as_conditions_rotation_is_a_latin_square(conditions: int) -> None:
    names = [f"c{index}" for index in range(conditions)]
    square = [Rotated().sequence(names, slot, RNG) for slot in range(conditions)]
    for line in [*square, *zip(*square, strict=True)]:
        assert sorted(line) == sorted(names)
