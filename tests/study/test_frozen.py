from __future__ import annotations

from pathlib import Path

import pytest
from protocol_page import changed_protocol

from omnistudy.errors.protocol import ProtocolFaults
from omnistudy.errors.study import ProtocolChanged
from omnistudy.protocol import Protocol
from omnistudy.study import check_unchanged, create_study, frozen_protocol


def test_the_frozen_protocol_comes_back(component: Protocol, tmp_path: Path) -> None:
    record = create_study(component, tmp_path / "a.db", "a")
    assert frozen_protocol(record) == component
    check_unchanged(record, changed_protocol())


def test_a_changed_protocol_is_refused_with_what_differs(
    component: Protocol, tmp_path: Path
) -> None:
    record = create_study(component, tmp_path / "a.db", "a")
    changed = changed_protocol("session.pause=10", "plant.mass=30")
    with pytest.raises(ProtocolChanged) as caught:
        check_unchanged(record, changed)
    said = str(caught.value)
    assert "session.pause: 60.0 -> 10.0" in said
    assert "plant.mass: 24.0 -> 30.0" in said
    assert len(said.splitlines()) == 3


def test_a_frozen_kind_that_is_not_installed_is_named(component: Protocol, tmp_path: Path) -> None:
    record = create_study(component, tmp_path / "a.db", "a")
    text = record.protocol_json.replace('"kind":"youbot"', '"kind":"lost_robot"')
    object.__setattr__(record, "protocol_json", text)
    with pytest.raises(ProtocolFaults, match=r"frozen protocol of 'a'.*'lost_robot'"):
        frozen_protocol(record)
