"""What a page shows of a protocol: the settings of its parts, and what conditions change."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import NamedTuple

from pydantic import BaseModel

from omnistudy.protocol.completion import PARTS
from omnistudy.protocol.diff import Difference, diff
from omnistudy.protocol.protocol import Protocol
from omnistudy.registry.field_unit import unit_of


class Setting(NamedTuple):
    """One resolved number or word of a part; `name` is its dotted path, `unit` may be "".

    A plain number has no unit here, though its field says "1".
    """

    name: str
    value: str
    unit: str


def settings(part: BaseModel, prefix: str = "") -> tuple[Setting, ...]:
    """List every setting of a part, nested ones by dotted path."""
    return tuple(_settings(part, prefix))


def changes(protocol: Protocol, condition: str) -> tuple[Difference, ...]:
    """List what a condition changes in the protocol's own set-up; raises UnknownCondition.

    A part of another kind is one change, of its kind; `parts_of` has its settings.
    """
    own = protocol.condition(condition)
    found: list[Difference] = []
    for part in PARTS:
        base, changed = getattr(protocol, part), getattr(own, part)
        if changed is not None and changed.kind != base.kind:
            found.append(Difference(f"{part}.kind", base.kind, changed.kind))
        elif changed is not None:
            texts = [json.dumps({part: model.model_dump(mode="json")}) for model in (base, changed)]
            found += diff(*texts)
    return tuple(found)


def parts_of(protocol: Protocol) -> Iterator[tuple[str, BaseModel]]:
    """Name every order, every part of the set-up but the world, and after it what replaces it."""
    for visit in protocol.course:
        for place, block in enumerate(visit.blocks, start=1):
            yield f"order of {visit.name}, block {place}", block.order
    for name in (*PARTS[1:], "recording", "messages"):
        base = getattr(protocol, name)
        yield name, base
        for condition in protocol.conditions:
            own = getattr(condition, name, None)
            if own is not None and own.kind != base.kind:
                yield f"{name} of {condition.name}", own


def _settings(part: BaseModel, prefix: str) -> Iterator[Setting]:
    for name, field in type(part).model_fields.items():
        value = getattr(part, name)
        if isinstance(value, BaseModel):
            yield from _settings(value, f"{prefix}{name}.")
        elif isinstance(value, tuple) and any(isinstance(item, BaseModel) for item in value):
            yield Setting(prefix + name, f"{len(value)} of them", "")
        else:
            yield Setting(prefix + name, _text(value), unit_of(field).removeprefix("1"))


def _text(value: object) -> str:
    if isinstance(value, tuple):
        return ", ".join(_text(item) for item in value) or "-"
    if isinstance(value, float):
        return f"{value:.6g}"
    return "-" if value is None or value == "" else str(value)
