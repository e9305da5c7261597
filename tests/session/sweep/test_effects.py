"""What a value changes is put together from parts; composing the whole page must say the same."""

from __future__ import annotations

from typing import Any

import pytest
from small_sweep import PROTOCOL, SHORT

from omnistudy.errors.protocol import ProtocolFaults
from omnistudy.protocol import freeze
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session.sweep.effects import Composer, Effects, canonical_tree, changed
from omnistudy.session.sweep.variables import read_words


def effects(*words: str) -> Effects:
    base = compose_protocol(PROTOCOL, SHORT)
    return Effects(Composer(PROTOCOL, SHORT), base, read_words(words).swept)


def assert_as_composed(known: Effects, values: dict[str, Any]) -> None:
    tree = canonical_tree(freeze(compose_protocol(PROTOCOL, SHORT)))
    composed = Composer(PROTOCOL, SHORT).protocol(values)
    assert changed(tree, known.changes(values)) == composed


def test_a_number_is_put_wherever_conditions_inherit_it() -> None:
    known = effects("law.stiffness.x=100,400")
    paths = {change.path for change in known.changes({"law.stiffness.x": 250})}
    assert ("law", "stiffness", "x") in paths
    assert len(paths) > 1, "conditions that only change the compliance centre inherit the gain"
    assert_as_composed(known, {"law.stiffness.x": 250})


def test_a_list_that_begins_with_the_protocols_own_value() -> None:
    known = effects("law.stiffness.x=198.5,400")
    assert known.changes({"law.stiffness.x": 400}) != ()
    assert_as_composed(known, {"law.stiffness.x": 400})
    assert_as_composed(known, {"law.stiffness.x": 198.5})


def test_words_choose_pages() -> None:
    known = effects("device=simulated_stick,direct", "law.stiffness.x=100,400")
    for device in ("simulated_stick", "direct"):
        assert_as_composed(known, {"device": device, "law.stiffness.x": 400})


def test_variables_that_work_on_the_same_part_are_composed_together() -> None:
    known = effects("device=simulated_stick,direct", "device.force_limit=5,10")
    assert_as_composed(known, {"device": "simulated_stick", "device.force_limit": 10})
    with pytest.raises(ProtocolFaults, match=r"device\.force_limit: unknown key"):
        known.changes({"device": "direct", "device.force_limit": 10})


def test_a_key_that_no_page_knows_names_the_nearest() -> None:
    with pytest.raises(ProtocolFaults, match=r"law\.stifness: unknown key.*'stiffness'"):
        effects("law.stifness.x=1,2")
