"""Instruments are found by name or file, the lab's first; faults are sentences."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.errors.survey import BrokenInstrument, UnknownInstrument
from omnistudy.survey import instrument_file, instrument_names, listed_instruments, load_instrument

PAGE = """\
name: short
title: Two questions
source: ours
language: de-CH
items:
  - {name: hands, kind: number, question: "Wie viele Hände?", whole: true, lowest: 0, highest: 2}
  - {name: comments, kind: text, question: "Sonst noch etwas?", required: false}
"""


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    (tmp_path / "survey").mkdir()
    (tmp_path / "survey" / "short.yaml").write_text(PAGE, encoding="utf-8")
    (tmp_path / "survey" / "torn.yaml").write_text("items: [", encoding="utf-8")
    return tmp_path


def faults(page: Path, text: str) -> tuple[str, ...]:
    page.write_text(text, encoding="utf-8")
    with pytest.raises(BrokenInstrument) as caught:
        load_instrument(page)
    assert all(fault.startswith(str(page)) for fault in caught.value.faults)
    return caught.value.faults


def test_names_are_the_labs_and_ours(lab: Path) -> None:
    assert {"short", "torn", "utah2017"} <= set(instrument_names(lab))
    assert "short" not in instrument_names()


def test_an_instrument_is_read_by_name_and_by_file(lab: Path) -> None:
    by_name = load_instrument("short", lab)
    assert by_name == load_instrument(lab / "survey" / "short.yaml")
    assert by_name.language == "de-CH"
    assert by_name.items[0].question == "Wie viele Hände?"


def test_the_labs_page_comes_before_ours(lab: Path) -> None:
    own = lab / "survey" / "utah2017.yaml"
    own.write_text(PAGE, encoding="utf-8")
    assert instrument_file("utah2017", lab) == own


def test_a_list_names_a_faulty_page_with_its_fault(lab: Path) -> None:
    listed = {entry.name: entry for entry in listed_instruments(lab)}
    assert (listed["short"].title, listed["short"].items) == ("Two questions", 2)
    assert listed["short"].fault == ""
    assert "not readable as YAML" in listed["torn"].fault


def test_an_unknown_name_gets_the_nearest(lab: Path) -> None:
    with pytest.raises(UnknownInstrument, match="did you mean 'short'"):
        load_instrument("shorts", lab)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("kind: text", "kind: txt", "unknown kind 'txt'"),
        ("kind: text, ", "", "items.comments: 'kind' is missing: it is one of likert, choice"),
        ("language", "langage", "langage: unknown key"),
        ("title: Two questions\n", "", "title: is missing"),
        ("name: comments", "name: hands", "two items have the name 'hands'"),
        ("highest: 2", "highest: -1", "must be below highest"),
        ("language: de-CH", "language: German, Swiss", "language: given 'German, Swiss'"),
    ],
)
def test_each_fault_is_one_sentence_with_its_place(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    assert old in PAGE
    found = faults(tmp_path / "page.yaml", PAGE.replace(old, new, 1))
    assert any(said in fault for fault in found), found


def test_every_fault_is_said_at_once(tmp_path: Path) -> None:
    broken = PAGE.replace("kind: text", "kind: txt").replace("title: Two questions\n", "")
    assert len(faults(tmp_path / "page.yaml", broken)) == 2


@pytest.mark.parametrize("text", ["", "- 1", "just words"])
def test_a_page_that_is_no_mapping_is_refused(tmp_path: Path, text: str) -> None:
    assert "a mapping of keys is needed" in faults(tmp_path / "page.yaml", text)[0]
