"""Limits of how badly an attempt may have been run to be analysed."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator, Field

from omnistudy.channel import MEASURES, SATURATED, is_measure
from omnistudy.registry import Model


def _known(name: str) -> str:
    if not is_measure(name):
        known = ", ".join((*MEASURES, f"{SATURATED}AXIS"))
        raise ValueError(f"there is no such measure; there are {known}")
    return name


class Limit(Model):
    """A measure of an attempt, and its greatest value; attempts above it are left out."""

    measure: Annotated[str, AfterValidator(_known)]
    """Name of the measure, such as late_steps (docs/database.md lists all)."""
    greatest: Annotated[float, Field(ge=0.0)]
    """In the measure's own unit; attempts without it, such as in simulated time, stay."""
