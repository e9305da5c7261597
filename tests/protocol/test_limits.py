"""Limits of a protocol: part of its design when stated, no part of its text when not."""

from __future__ import annotations

import json

import pytest
from protocol_page import changed_protocol
from pydantic import ValidationError

from omnistudy.protocol import Protocol, freeze, thaw
from omnistudy.protocol.limit import Limit


def limited(protocol: Protocol, *limits: Limit) -> Protocol:
    return protocol.model_copy(update={"limits": limits})


def test_a_protocol_without_limits_says_nothing_of_them() -> None:
    assert "limits" not in json.loads(freeze(changed_protocol()).canonical_json)


def test_limits_belong_to_the_design_and_come_back() -> None:
    plain = changed_protocol()
    stated = limited(plain, Limit(measure="late_steps", greatest=10))
    before, after = freeze(plain), freeze(stated)
    assert before.design_hash != after.design_hash
    assert before.site_hash == after.site_hash
    assert thaw(after.canonical_json).limits == (Limit(measure="late_steps", greatest=10),)


def test_another_number_is_another_design() -> None:
    designs = {
        freeze(limited(changed_protocol(), Limit(measure="lost_rows", greatest=n))).design_hash
        for n in (0, 1)
    }
    assert len(designs) == 2


@pytest.mark.parametrize("name", ["late_steps", "turn_lateness_p99", "saturated_stick_x"])
def test_every_measure_can_be_limited(name: str) -> None:
    assert Limit(measure=name, greatest=0.5).measure == name


@pytest.mark.parametrize("name", ["late_step", "saturated_", ""])
def test_what_is_no_measure_is_refused_with_the_names_of_all(name: str) -> None:
    with pytest.raises(ValidationError, match="there is no such measure; there are late_steps"):
        Limit(measure=name, greatest=1)
