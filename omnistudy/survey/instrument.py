"""An instrument: a list of questions with its source and its language."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from omnistudy.registry import Model
from omnistudy.registry.name import Name
from omnistudy.survey.item import Item


class Instrument(Model):
    """What people are asked, as data; who asks it and when is another's."""

    name: Name
    title: Annotated[str, Field(min_length=1)]
    source: Annotated[str, Field(min_length=1)]
    """Publication and page, or "ours"."""
    language: Annotated[str, Field(pattern=r"^[a-z]{2,3}(-[A-Za-z0-9]+)*$")]
    """Language of all that is read, such as en or de-CH (BCP 47)."""
    introduction: str = ""
    """What is read before the first item."""
    items: Annotated[tuple[Item, ...], Field(min_length=1)]

    @model_validator(mode="after")
    def _names_differ(self) -> Self:
        names = [item.name for item in self.items]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ValueError(f"two items have the name '{twice[0]}': every name must differ")
        return self
