"""The scale of a rating: whole numbers, some of them with a word."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from omnistudy.registry import Model


class Anchor(Model):
    """What one point of a scale means, in the language of the instrument."""

    value: int
    label: Annotated[str, Field(min_length=1)]


class Scale(Model):
    """Whole numbers from `lowest` to `highest`; both ends have an anchor, others may."""

    lowest: int = 1
    highest: int
    anchors: tuple[Anchor, ...]

    @property
    def points(self) -> tuple[int, ...]:
        """Every answer that may be given."""
        return tuple(range(self.lowest, self.highest + 1))

    @model_validator(mode="after")
    def _anchored(self) -> Self:
        if self.lowest >= self.highest:
            raise ValueError(f"lowest ({self.lowest}) must be below highest ({self.highest})")
        values = [anchor.value for anchor in self.anchors]
        outside = [value for value in values if not self.lowest <= value <= self.highest]
        if outside:
            raise ValueError(
                f"an anchor stands at {outside[0]}, but the scale goes from {self.lowest} to "
                f"{self.highest}"
            )
        if len(set(values)) < len(values):
            raise ValueError("two anchors stand at the same value: each point has one at most")
        if not {self.lowest, self.highest} <= set(values):
            raise ValueError(
                f"both ends ({self.lowest} and {self.highest}) need an anchor, so that nobody "
                "answers the wrong way round"
            )
        return self
