"""Visits: when a participant comes, and which blocks of trials there are."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from omnistudy.protocol.condition import Level
from omnistudy.protocol.fields import AnyOrder, Name
from omnistudy.registry import Model

TrialKind = Literal["familiarisation", "practice", "main", "catch", "retention"]
"""What a trial is for: only `main` and `retention` answer the study's question."""


class Catch(Model):
    """Trials of one condition that come where nobody expects them."""

    condition: Name
    """Met in these trials."""
    trials: Annotated[int, Field(ge=1, le=50)] = 1
    """How many; their places are drawn, never the first, never two together."""


class Block(Model):
    """Trials of one kind in one order."""

    kind: TrialKind = "main"
    """What its trials are for."""
    only: tuple[Level, ...] = ()
    """A mapping from a factor to a level: conditions that have another are left out."""
    order: AnyOrder
    """In which sequence a participant meets the conditions."""
    routes: tuple[str, ...] = ()
    """Instead of the protocol's."""
    catch: Catch | None = None
    """Trials of kind `catch` between those of the block."""


class Days(Model):
    """When a visit may be, in days after the first."""

    earliest: Annotated[int, Field(ge=0, le=3650)]
    """Not before this day."""
    latest: Annotated[int, Field(ge=0, le=3650)]
    """Not after this day."""

    @model_validator(mode="after")
    def _open(self) -> Self:
        if self.latest < self.earliest:
            raise ValueError("latest must not be before earliest")
        return self


class Visit(Model):
    """What happens on one day."""

    name: Name
    """What people call it."""
    days: Days | None = None
    """Window after the first visit, which has none."""
    blocks: Annotated[tuple[Block, ...], Field(min_length=1)]
    """In the order of time."""
