"""Validation faults in the words of a protocol's page: where, what was given, what is allowed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, get_args

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from omnistudy.errors import OmnistudyError, nearest
from omnistudy.protocol.completion import PARTS
from omnistudy.protocol.summary import unit_of
from omnistudy.registry import load_kind

KIND_KEYS = (*PARTS, "order")
"""Keys whose `kind` selects the model."""

REPEATED_LONGEST = 60
"""Characters of what was given that are repeated."""


class _Place(NamedTuple):
    """Where a fault lies: its path on the page, the models around it, its own field."""

    path: str
    around: tuple[type[BaseModel], ...]
    field: FieldInfo | None


def explained(
    error: ValidationError, model: type[BaseModel], tree: Mapping[str, Any]
) -> tuple[str, ...]:
    """Give one sentence a fault; what conditions only inherit from a faulty part is told once."""
    faults = error.errors(include_url=False)
    own = [fault for fault in faults if fault["loc"][0] != "conditions"]
    inheriting = [fault for fault in faults if fault["loc"][0] == "conditions"]
    sentences: list[str] = []
    told: set[str] = set()
    for fault in own:
        place = _place(fault["loc"], model, tree)
        told.add(place.path)
        sentences.append(f"{place.path}: {_sentence(fault, place)}")
    for fault in inheriting:
        place = _place(fault["loc"], model, tree)
        inside = place.path.split(".", 2)[-1]
        if inside not in told:
            sentences.append(f"{place.path}: {_sentence(fault, place)}")
    return tuple(sentences)


def _sentence(fault: ErrorDetails, place: _Place) -> str:
    if fault["type"] == "extra_forbidden":
        keys = [key for model in place.around for key in model.model_fields]
        hint = nearest(str(fault["loc"][-1]), keys)
        return f"unknown key; the keys here are {', '.join(dict.fromkeys(keys))}{hint}"
    if fault["type"] == "missing":
        return "is missing and has no default"
    if fault["type"].startswith("kind_"):
        return fault["msg"]
    reason = fault["msg"].removeprefix("Value error, ").replace("Input should", "it should")
    unit = unit_of(place.field) if place.field else ""
    in_unit = f" (in {unit})" if unit and f" in {unit}" not in reason else ""
    return f"given {_shortened(fault['input'])}, but {reason}{in_unit}"


def _place(steps: Sequence[str | int], model: type[BaseModel], tree: Mapping[str, Any]) -> _Place:
    """Walk from the root to a fault along its steps, through the models that kinds select."""
    path: list[str] = []
    around: tuple[type[BaseModel], ...] = ()
    models: tuple[type[BaseModel], ...] = (model,)
    field: FieldInfo | None = None
    value: Any = tree
    for step in steps:
        tagged = tuple(found for found in models if _tag(found) == step)
        if tagged and not (isinstance(value, Mapping) and step in value):
            models = tagged
            continue
        value = _inside(value, step)
        path.append(_label(step, value))
        if isinstance(step, str):
            around = models
            field = next((m.model_fields[step] for m in models if step in m.model_fields), None)
            models = _selected(step, value) or _models_in(field.annotation if field else None)
    return _Place(".".join(path), around, field)


def _inside(value: Any, step: str | int) -> Any:
    try:
        return value[step]
    except (KeyError, IndexError, TypeError):
        return None


def _label(step: str | int, value: Any) -> str:
    """Call an item of a list by its name, as the page does."""
    if isinstance(step, int):
        named = value if isinstance(value, Mapping) else {}
        return str(named.get("name") or named.get("factor") or step + 1)
    return step


def _selected(key: str, value: Any) -> tuple[type[BaseModel], ...]:
    if key not in KIND_KEYS or not isinstance(value, Mapping):
        return ()
    try:
        return (load_kind(f"{key}s", str(value.get("kind"))),)
    except OmnistudyError:
        return ()


def _models_in(annotation: Any) -> tuple[type[BaseModel], ...]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return (annotation,)
    return tuple(model for part in get_args(annotation) for model in _models_in(part))


def _tag(model: type[BaseModel]) -> Any:
    for key in ("kind", "shape"):
        if key in model.model_fields:
            return model.model_fields[key].default
    return None


def _shortened(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= REPEATED_LONGEST else f"{text[:REPEATED_LONGEST]}..."
