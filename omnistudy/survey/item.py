"""One question, by what an answer to it can be."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from omnistudy.registry import KindModel, Model
from omnistudy.registry.name import Name
from omnistudy.survey.scale import Scale

Words = Annotated[str, Field(min_length=1)]
"""What a person reads, in the language of the instrument."""


class Question(KindModel, ABC):
    """What every item has."""

    name: Name
    """Column of the answer; differs from item to item."""
    question: Words
    """As it is asked."""
    conditions: tuple[Name, ...] = ()
    """Conditions of the protocol that it asks about; empty for the whole session."""
    required: bool = True
    """Whether it must be answered before the page can be left."""
    source: str = ""
    """Where it comes from, where that differs from the instrument's source."""

    @property
    @abstractmethod
    def answers(self) -> str:
        """What may be answered, in words."""


class LikertItem(Question):
    """A rating on a scale."""

    kind: Literal["likert"] = "likert"
    scale: Scale

    @property
    def answers(self) -> str:
        """The scale's points, with the words of those that have one."""
        words = {anchor.value: f" {anchor.label}" for anchor in self.scale.anchors}
        return ", ".join(f"{value}{words.get(value, '')}" for value in self.scale.points)


class Option(Model):
    """One answer that may be chosen."""

    name: Name
    """What is stored."""
    text: Words
    """What is read."""
    conditions: tuple[Name, ...] = ()
    """Conditions of the protocol that choosing it means."""
    source: str = ""
    """Where it comes from, where that differs from the item's."""


class ChoiceItem(Question):
    """One answer out of several."""

    kind: Literal["choice"] = "choice"
    options: Annotated[tuple[Option, ...], Field(min_length=2)]

    @property
    def answers(self) -> str:
        """The options as they are read."""
        return " / ".join(option.text for option in self.options)

    @model_validator(mode="after")
    def _options_differ(self) -> Self:
        names = [option.name for option in self.options]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ValueError(f"two options have the name '{twice[0]}': every name must differ")
        return self


class NumberItem(Question):
    """A number, such as an age."""

    kind: Literal["number"] = "number"
    unit: str = ""
    """As it is read beside the field; "" for what has none."""
    whole: bool = False
    """Whether only whole numbers are answers."""
    lowest: float | None = None
    """Least that may be answered, in `unit`."""
    highest: float | None = None
    """Most that may be answered, in `unit`."""

    @property
    def answers(self) -> str:
        """The kind of number, its bounds and its unit."""
        bounds = [
            f"{word} {bound:g}"
            for word, bound in (("from", self.lowest), ("to", self.highest))
            if bound is not None
        ]
        number = "a whole number" if self.whole else "a number"
        return " ".join([number, *bounds, *([self.unit] if self.unit else [])])

    @model_validator(mode="after")
    def _bounds_leave_room(self) -> Self:
        if self.lowest is not None and self.highest is not None and self.lowest >= self.highest:
            raise ValueError(f"lowest ({self.lowest:g}) must be below highest ({self.highest:g})")
        return self


class TextItem(Question):
    """Words of the person's own."""

    kind: Literal["text"] = "text"

    @property
    def answers(self) -> str:
        """Any words."""
        return "words"


Item = Annotated[LikertItem | ChoiceItem | NumberItem | TextItem, Field(discriminator="kind")]
"""Any question; `kind` tells which."""
