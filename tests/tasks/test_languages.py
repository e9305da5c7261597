"""Every language says everything."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest

from omnistudy.session.parts import part, part_names
from omnistudy.tasks import Messages

LANGUAGES = part_names("messages")


def sentences(tree: Any, path: str = "") -> Iterator[tuple[str, str]]:
    """Give the path and text of every sentence; lists of paragraphs count as one."""
    for name, value in tree.items():
        where = f"{path}{name}"
        if isinstance(value, dict):
            yield from sentences(value, f"{where}.")
        elif name == "blocks":
            yield from ((f"blocks.{block['name']}", block["word"]) for block in value)
        else:
            yield where, "\n".join(value) if isinstance(value, tuple | list) else value or ""


def language(name: str) -> dict[str, str]:
    page: Messages = part("messages", name)
    return dict(sentences(page.model_dump()))


@pytest.mark.parametrize("name", LANGUAGES)
def test_a_language_lacks_no_sentence_and_no_place_to_fill_in(name: str) -> None:
    english, own = language("en"), language(name)
    assert own["language"] == name
    assert own.keys() == english.keys()
    for where, sentence in own.items():
        assert sentence, where
        assert re.findall(r"{\w+}", sentence) == re.findall(r"{\w+}", english[where]), where


def test_german_is_another_language() -> None:
    english, german = language("en"), language("de")
    same = {where for where in english if english[where] == german[where]}
    assert same == set()


def test_no_letter_is_asked_for_twice_and_german_has_its_own() -> None:
    for name in LANGUAGES:
        letters = language(name)["pages.controls.letters"].replace("\n", "")
        assert len(letters) == len(set(letters))
    assert set("äöüß") < set(language("de")["pages.controls.letters"])
