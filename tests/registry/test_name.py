"""What code, files and tables call a thing."""

from __future__ import annotations

import pytest
from pydantic import TypeAdapter, ValidationError

from omnistudy.registry.name import Name

NAME: TypeAdapter[str] = TypeAdapter(Name)


@pytest.mark.parametrize("name", ["a", "soft_wall", "p2", "x" * 60])
def test_small_letters_digits_and_underscores_are_names(name: str) -> None:
    assert NAME.validate_python(name) == name


@pytest.mark.parametrize("name", ["", "Grip", "2nd", "_x", "a-b", "a b", "ä", "a\n", "x" * 61])
def test_everything_else_is_none(name: str) -> None:
    with pytest.raises(ValidationError):
        NAME.validate_python(name)
