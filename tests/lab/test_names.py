"""Which names a new thing may have."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.errors.lab import BadName, TakenName
from omnistudy.lab import NOUNS
from omnistudy.lab.names import check_name, class_name


@pytest.fixture(autouse=True)
def _no_lab(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)


@pytest.mark.parametrize("noun", NOUNS)
@pytest.mark.parametrize("name", ["grip", "soft_wall", "a2", "x" * 60])
def test_a_free_name_is_good(noun: str, name: str) -> None:
    check_name(noun, name, None)


@pytest.mark.parametrize("noun", NOUNS)
@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("Grip", "write small letters"),
        ("2nd", "write small letters"),
        ("../grip", "write small letters"),
        ("x" * 61, "60 at most"),
        ("", "write small letters"),
        ("class", "a word of Python itself"),
        ("yes", "YAML reads it as True"),
        ("null", "YAML reads it as None"),
    ],
)
def test_what_cannot_be_a_name_is_one_sentence(noun: str, name: str, said: str) -> None:
    with pytest.raises(BadName, match=said) as caught:
        check_name(noun, name, None)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("noun", "name"),
    [
        ("law", "component"),
        ("controller", "rate"),
        ("world", "utah2017"),
        ("protocol", "utah2017_component"),
        ("survey", "utah2017"),
    ],
)
def test_a_name_of_ours_is_taken(noun: str, name: str) -> None:
    with pytest.raises(TakenName, match=f"there is a {noun} '{name}' already"):
        check_name(noun, name, None)


@pytest.mark.parametrize(
    ("noun", "page"),
    [
        ("law", "law/mine.yaml"),
        ("controller", "controller/mine.yaml"),
        ("world", "world/mine.yaml"),
        ("protocol", "protocols/mine.yaml"),
        ("protocol", "mine.yaml"),
        ("survey", "survey/mine.yaml"),
    ],
)
def test_a_name_of_the_labs_is_taken(tmp_path: Path, noun: str, page: str) -> None:
    check_name(noun, "mine", tmp_path)
    (tmp_path / page).parent.mkdir(exist_ok=True)
    (tmp_path / page).write_text("kind: none\n")
    with pytest.raises(TakenName):
        check_name(noun, "mine", tmp_path)


def test_the_same_name_may_stand_for_things_of_different_nouns() -> None:
    check_name("law", "utah2017", None)


def test_a_class_is_not_called_like_the_one_that_it_extends() -> None:
    with pytest.raises(BadName, match="WrenchLaw"):
        check_name("law", "wrench", None)
    check_name("controller", "wrench", None)


@pytest.mark.parametrize(
    ("noun", "name", "cls"),
    [("law", "soft_wall", "SoftWallLaw"), ("controller", "p2", "P2Controller")],
)
def test_a_class_is_called_after_its_kind(noun: str, name: str, cls: str) -> None:
    assert class_name(noun, name) == cls
