"""Validation faults of a protocol's page; what conditions only inherit is told once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel, ValidationError

from omnistudy.registry.faults import faults

CONDITIONS = "conditions."


def explained(
    error: ValidationError, model: type[BaseModel], tree: Mapping[str, Any]
) -> tuple[str, ...]:
    """Give one sentence a fault, the protocol's own parts before the conditions'."""
    found = faults(error, model, tree)
    own = [fault for fault in found if not fault.path.startswith(CONDITIONS)]
    told = {fault.path for fault in own}
    inside = [
        fault
        for fault in found
        if fault.path.startswith(CONDITIONS) and fault.path.split(".", 2)[-1] not in told
    ]
    return tuple(f"{fault.path}: {fault.sentence}" for fault in (*own, *inside))
