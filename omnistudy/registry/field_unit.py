"""The unit that a field's type carries."""

from __future__ import annotations

from collections.abc import Iterator
from typing import get_args

from pydantic import WithJsonSchema
from pydantic.fields import FieldInfo


def unit_of(field: FieldInfo | None) -> str:
    """Give the unit of a field, "" for what has none."""
    for item in metadata_of(field) if field else ():
        if isinstance(item, WithJsonSchema) and item.json_schema is not None:
            return str(item.json_schema.get("unit", ""))
    return ""


def metadata_of(field: FieldInfo) -> Iterator[object]:
    """Give what is annotated to a field, inside `... | None` too."""
    yield from field.metadata
    yield from _annotated(field.annotation)


def _annotated(annotation: object) -> Iterator[object]:
    yield from getattr(annotation, "__metadata__", ())
    for part in get_args(annotation):
        yield from _annotated(part)
