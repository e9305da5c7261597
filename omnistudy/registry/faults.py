"""From pydantic's faults to sentences: where on the page, what was given, what is allowed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, get_args

from pydantic import BaseModel, ValidationError, WithJsonSchema
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from omnistudy.errors import nearest

REPEATED_LONGEST = 60
"""Characters of what was given that are repeated."""


class _Place(NamedTuple):
    """Where a fault lies: its path on the page, the models around it, its own field."""

    path: str
    around: tuple[type[BaseModel], ...]
    field: FieldInfo | None


def explain(
    error: ValidationError, model: type[BaseModel], tree: Any, where: str
) -> tuple[str, ...]:
    """Give one sentence a fault, each opening with the page and the path inside it.

    model : what the page was read as.
    tree : the page's content, which lends the path the names of list items.
    where : the page, as its reader knows it.
    """
    return tuple(
        f"{where}: {_sentence(fault, _place(fault, model, tree))}"
        for fault in error.errors(include_url=False)
    )


def _sentence(fault: ErrorDetails, place: _Place) -> str:
    if fault["type"] == "extra_forbidden":
        keys = list(dict.fromkeys(key for model in place.around for key in model.model_fields))
        key = str(fault["loc"][-1])
        return f"{place.path}: unknown key; the keys here are {', '.join(keys)}{nearest(key, keys)}"
    if fault["type"] == "missing":
        return f"{place.path}: is missing and has no default"
    if fault["type"] in ("model_type", "dict_type"):
        return f"{place.path}: given {_shortened(fault['input'])}, but a mapping of keys is needed"
    reason = fault["msg"].removeprefix("Value error, ").replace("Input should", "it should")
    unit = _unit(place.field)
    given = _shortened(fault["input"])
    return f"{place.path}: given {given}, but {reason}{f' (in {unit})' if unit else ''}"


def _shortened(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= REPEATED_LONGEST else f"{text[:REPEATED_LONGEST]}..."


def _place(fault: ErrorDetails, model: type[BaseModel], tree: Any) -> _Place:
    """Walk from the root of the page to the fault, through the models on the way."""
    path: list[str] = []
    around: tuple[type[BaseModel], ...] = (model,)
    models = around
    field: FieldInfo | None = None
    value = tree
    for step in fault["loc"]:
        tagged = tuple(found for found in models if _shape(found) == step)
        if tagged:
            models = around = tagged
            continue
        value = _inside(value, step)
        path.append(_label(step, value))
        if isinstance(step, str):
            around = models
            field = next((m.model_fields[step] for m in models if step in m.model_fields), None)
            models = _models_in(field.annotation if field else None)
    return _Place(".".join(path) or "the whole page", around, field)


def _inside(value: Any, step: str | int) -> Any:
    try:
        return value[step]
    except (KeyError, IndexError, TypeError):
        return None


def _label(step: str | int, value: Any) -> str:
    """Call an item of a list by its name where it has one, else by its place from 1."""
    if isinstance(step, str):
        return step
    return str(value.get("name", step + 1)) if isinstance(value, Mapping) else str(step + 1)


def _models_in(annotation: Any) -> tuple[type[BaseModel], ...]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return (annotation,)
    return tuple(model for part in get_args(annotation) for model in _models_in(part))


def _shape(model: type[BaseModel]) -> Any:
    """Give what pydantic puts on the path for one member of a tagged union."""
    field = model.model_fields.get("shape")
    return field.default if field else None


def _unit(field: FieldInfo | None) -> str:
    for item in field.metadata if field else ():
        if isinstance(item, WithJsonSchema) and item.json_schema is not None:
            return str(item.json_schema.get("unit", ""))
    return ""
