"""An amendment mends texts; design, allocation and what was run stay as they were."""

from __future__ import annotations

from pathlib import Path

import pytest
from protocol_page import changed_protocol

import omnistudy
from omnistudy.errors.study import DesignChanged, NothingAmended
from omnistudy.study import amend_study, create_study

SMALL = "participants.count=3"


@pytest.fixture
def small(tmp_path: Path) -> Path:
    path = tmp_path / "small.db"
    create_study(changed_protocol(SMALL), path, "small")
    return path


def test_mended_texts_draw_nothing_anew(small: Path) -> None:
    with omnistudy.open(small) as study:
        before = study.allocations(), study.trials().drop(columns="protocol_version"), study.study
    made = amend_study(
        small,
        changed_protocol(
            SMALL,
            "title=Mended",
            "messages.good_job=Well done",
            "conditions.none.masked_label=B",
            "conditions.full.masked_label=A",
        ),
        "a typing mistake",
    )
    assert made.version == 2
    assert {change.path for change in made.differences} == {
        "title",
        "messages.good_job",
        "conditions.none.masked_label",
        "conditions.full.masked_label",
    }
    with omnistudy.open(small) as study:
        assert study.allocations().equals(before[0])
        assert study.trials().drop(columns="protocol_version").equals(before[1])
        assert set(study.trials()["protocol_version"]) == {2}
        assert study.study.title == "Mended"
        assert study.study.design_hash == before[2].design_hash
        assert study.study.site_hash != before[2].site_hash
        labels = study.conditions().set_index("condition")["masked_label"]
        assert (labels["none"], labels["full"]) == ("B", "A")
        first, second = study.protocol_versions()
    assert first.protocol_json == before[2].protocol_json
    assert (first.version, first.reason) == (1, "first freeze")
    assert (second.version, second.reason) == (2, "a typing mistake")


def test_another_design_is_refused_with_what_differs(small: Path) -> None:
    with pytest.raises(DesignChanged, match=r"law\.stiffness\.x: 198\.\d+ -> 100"):
        amend_study(small, changed_protocol(SMALL, "law.stiffness.x=100"), "stronger")
    with omnistudy.open(small) as study:
        assert study.study.protocol_version == 1


def test_there_must_be_something_to_amend(small: Path) -> None:
    with pytest.raises(NothingAmended):
        amend_study(small, changed_protocol(SMALL), "nothing")
