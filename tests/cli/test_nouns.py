"""One grammar: what is a thing can be listed and shown."""

from __future__ import annotations

import pytest
from typer.core import TyperGroup

from omnistudy.cli.app import NOUNS, LazyNoun, command_tree

DO = {"demo", "drive", "new", "replay", "report", "session", "sweep", "view"}
"""Nouns that do something and have no things of their own to be listed."""


@pytest.mark.parametrize("noun", sorted(set(NOUNS) - DO))
def test_what_is_a_thing_can_be_listed_and_shown(noun: str) -> None:
    lazy = command_tree().commands[noun]
    assert isinstance(lazy, LazyNoun)
    group = lazy.load()
    assert isinstance(group, TyperGroup)
    assert {"list", "show"} <= set(group.commands)
    for verb in ("list", "show"):
        options = {option for each in group.commands[verb].params for option in each.opts}
        assert "--json" in options
        assert f"Example: omnistudy {noun} {verb}" in (group.commands[verb].help or "")
