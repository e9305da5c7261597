"""Conditions, the factors that they vary, and what each changes in the set-up."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from omnistudy.protocol.fields import (
    AnyController,
    AnyDevice,
    AnyLaw,
    AnyOperator,
    AnyPlant,
    AnyTask,
    AnyWorld,
    Name,
)
from omnistudy.registry import Model


def _as_text(value: Any) -> Any:
    if isinstance(value, bool):
        raise ValueError("a word or a number is needed; YAML reads on, off, yes and no as truth")
    return f"{value:g}" if isinstance(value, int | float) else value


LevelText = Annotated[str, BeforeValidator(_as_text), Field(min_length=1)]
"""A level as text, as it stands in the database; a number becomes its shortest text."""


class Factor(Model):
    """Something that conditions vary."""

    name: Name
    """What the database calls it."""
    vary: Literal["within", "between"] = "within"
    """Within participants, who then meet every level, or between them: each meets one."""
    levels: Annotated[tuple[LevelText, ...], Field(min_length=1)]
    """Every level that a condition may have."""


class Level(Model):
    """Which level a condition has of one factor."""

    factor: Name
    """Name of the factor."""
    level: LevelText
    """One of its levels."""


class Condition(Model):
    """One condition; a part that is None is the protocol's own."""

    name: Name
    """What the database calls it."""
    masked_label: Annotated[str, Field(min_length=1)]
    """What is shown to those who must not know the condition."""
    levels: tuple[Level, ...]
    """One level for every factor."""
    world: AnyWorld | None = None
    """Only what differs from the protocol's world."""
    plant: AnyPlant | None = None
    """Only what differs from the protocol's plant."""
    device: AnyDevice | None = None
    """Only what differs from the protocol's device."""
    controller: AnyController | None = None
    """Only what differs from the protocol's controller."""
    law: AnyLaw | None = None
    """Only what differs from the protocol's law."""
    operator: AnyOperator | None = None
    """Only what differs from the protocol's operator."""
    task: AnyTask | None = None
    """Only what differs from the protocol's task."""
