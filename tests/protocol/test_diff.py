from __future__ import annotations

import json

from hypothesis import given
from hypothesis import strategies as st

from omnistudy.protocol.diff import Difference, diff


def told(old: object, new: object) -> list[str]:
    return [str(difference) for difference in diff(json.dumps(old), json.dumps(new))]


def test_a_changed_value_is_told_with_its_path() -> None:
    assert told({"law": {"kind": "k", "x": 1.0}}, {"law": {"kind": "k", "x": 2.0}}) == [
        "law.x: 1.0 -> 2.0"
    ]


def test_named_things_are_compared_by_name() -> None:
    old = {"conditions": [{"name": "a", "n": 1}, {"name": "b", "n": 2}]}
    new = {"conditions": [{"name": "b", "n": 3}, {"name": "c", "n": 1}]}
    assert told(old, new) == [
        'conditions.a: taken out, was {"name": "a", "n": 1}',
        "conditions.b.n: 2 -> 3",
        'conditions.c: added {"name": "c", "n": 1}',
    ]


def test_another_order_of_the_same_things_is_a_difference() -> None:
    old = [{"name": "a"}, {"name": "b"}]
    assert told({"x": old}, {"x": old[::-1]}) == ['x (their order): ["a", "b"] -> ["b", "a"]']


def test_a_part_of_another_kind_is_one_difference() -> None:
    assert told({"law": {"kind": "a", "x": 1}}, {"law": {"kind": "b"}}) == [
        'law: {"kind": "a", "x": 1} -> {"kind": "b"}'
    ]


def test_a_long_value_is_cut_in_the_line_but_not_in_the_value() -> None:
    (difference,) = diff(json.dumps({"a": "x"}), json.dumps({"a": "y" * 500}))
    assert len(str(difference)) < 150
    assert difference.new == json.dumps("y" * 500)
    assert isinstance(difference, Difference)


trees = st.recursive(
    st.integers() | st.text(max_size=2),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=2), inner),
    max_leaves=8,
)


@given(trees, trees)
def test_there_is_a_difference_exactly_when_the_texts_differ(old: object, new: object) -> None:
    assert bool(told(old, new)) is (old != new)
