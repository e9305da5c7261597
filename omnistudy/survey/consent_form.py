"""A consent form: what people read before they take part, and what they are asked to agree to."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from omnistudy.registry import Model
from omnistudy.registry.name import Name

Words = Annotated[str, Field(min_length=1)]


class Section(Model):
    """One part of the text."""

    heading: Words
    paragraphs: Annotated[tuple[Words, ...], Field(min_length=1)]


class Asked(Model):
    """One thing to agree to by a tick of its own."""

    name: Name
    """What is stored."""
    text: Words
    """What is read."""
    required: bool = True
    """Whether nobody takes part without it."""


class ConsentForm(Model):
    """The text of one version in one language; what was signed never changes with it."""

    title: Words
    version: Words
    """Told with every answer, so that it is known what was agreed to."""
    language: Annotated[str, Field(pattern=r"^[a-z]{2,3}(-[A-Za-z0-9]+)*$")]
    """Language of all that is read, such as en or de-CH (BCP 47)."""
    sections: Annotated[tuple[Section, ...], Field(min_length=1)]
    asked: tuple[Asked, ...] = ()

    @model_validator(mode="after")
    def _names_differ(self) -> Self:
        names = [one.name for one in self.asked]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ValueError(f"'{twice[0]}' is asked twice: every name must differ")
        return self


class ConsentAnswer(Model):
    """What a person said to a form."""

    version: str
    agreed: bool
    ticked: tuple[Name, ...] = ()
    """What was ticked, in the form's order."""
