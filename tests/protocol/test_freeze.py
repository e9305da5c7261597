from __future__ import annotations

import json
import random
import re
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from protocol_page import changed_protocol
from pydantic import ValidationError

from omnistudy.protocol import Protocol, freeze, thaw

Path = tuple[str | int, ...]


def leaves(tree: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield from leaves(value, (*path, key))
    elif isinstance(tree, list):
        for index, value in enumerate(tree):
            yield from leaves(value, (*path, index))
    else:
        yield path, tree


def changed(canonical: str, path: Path, value: Any) -> str:
    tree = json.loads(canonical)
    inside = tree
    for step in path[:-1]:
        inside = inside[step]
    inside[path[-1]] = value
    return json.dumps(tree)


COMPONENT = freeze(changed_protocol())
LEAVES = list(leaves(json.loads(COMPONENT.canonical_json)))
NUMBERS = [
    (path, value)
    for path, value in LEAVES
    if isinstance(value, int | float) and not isinstance(value, bool)
]
SITE = {"title", "description", "site", "messages", "device"}


def of_site(path: Path) -> bool:
    return path[0] in SITE or path[-1] == "masked_label"


def test_the_text_is_canonical() -> None:
    text = COMPONENT.canonical_json
    again = json.dumps(json.loads(text), sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    assert text == again
    assert len(COMPONENT.design_hash) == len(COMPONENT.site_hash) == 64


def test_a_frozen_protocol_comes_back_whole(component: Protocol) -> None:
    back = thaw(COMPONENT.canonical_json)
    assert back == component
    assert freeze(back) == COMPONENT
    assert type(back.law) is type(component.law)


@given(st.sampled_from(NUMBERS), st.floats(1e-3, 5.0))
@settings(max_examples=80, deadline=None, suppress_health_check=[HealthCheck.filter_too_much])
def test_any_number_changes_the_hash_of_its_side_alone(
    leaf: tuple[Path, float], difference: float
) -> None:
    path, value = leaf
    step = max(1, round(difference)) if isinstance(value, int) else difference
    try:
        frozen = freeze(thaw(changed(COMPONENT.canonical_json, path, value + step)))
    except ValidationError:
        assume(False)
    assert (frozen.design_hash == COMPONENT.design_hash) is of_site(path)
    assert (frozen.site_hash == COMPONENT.site_hash) is not of_site(path)


@pytest.mark.parametrize(
    ("path", "text"),
    [
        pytest.param(path, value, id=".".join(str(step) for step in path))
        for path, value in LEAVES
        if isinstance(value, str) and of_site(path) and value
    ],
)
def test_mending_a_text_changes_the_site_hash_alone(path: Path, text: str) -> None:
    places = "".join(re.findall(r"{\w+}", text))
    try:
        frozen = freeze(thaw(changed(COMPONENT.canonical_json, path, f"mended{places}")))
    except ValidationError:
        assert path[-1] in {"status", "kind"}
        return
    assert frozen.design_hash == COMPONENT.design_hash
    assert frozen.site_hash != COMPONENT.site_hash


@pytest.mark.parametrize(
    "override",
    [
        "order.block_length=2",
        "order.last=[zero_torque,centre_front_20,centre_rear_10,centre_front_10]",
        "routes=[red-blue-green,red-green-blue,blue-green-red]",
        "participants.study_key=other",
        "conditions.full.law.as_published=true",
        "conditions.zero_torque.law.as_published=true",
        "world.title=another",
        "name=another",
    ],
)
def test_a_change_of_the_design_changes_the_design_hash_alone(override: str) -> None:
    frozen = freeze(changed_protocol(override))
    assert frozen.design_hash != COMPONENT.design_hash
    assert frozen.site_hash == COMPONENT.site_hash


def test_a_condition_that_changes_the_device_makes_it_design() -> None:
    frozen = freeze(changed_protocol("conditions.full.device.force_limit=10"))
    assert frozen.design_hash != COMPONENT.design_hash


@given(st.randoms(use_true_random=False))
@settings(max_examples=20, deadline=None)
def test_the_order_of_keys_says_nothing(chance: random.Random) -> None:
    def shuffled(tree: Any) -> Any:
        if isinstance(tree, list):
            return [shuffled(value) for value in tree]
        if not isinstance(tree, dict):
            return tree
        keys = list(tree)
        chance.shuffle(keys)
        return {key: shuffled(tree[key]) for key in keys}

    tree = shuffled(json.loads(COMPONENT.canonical_json))
    assert freeze(thaw(json.dumps(tree))) == COMPONENT


def test_negative_zero_is_zero() -> None:
    plain = changed_protocol("law.compliance_centre=0.0")
    negative = changed_protocol("law.compliance_centre=-0.0")
    assert freeze(plain) == freeze(negative)


def test_a_whole_number_is_the_same_number() -> None:
    whole = changed_protocol("law.compliance_centre=1")
    broken = changed_protocol("law.compliance_centre=1.0")
    assert freeze(whole) == freeze(broken)
