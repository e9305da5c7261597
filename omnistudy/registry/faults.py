"""From pydantic's faults to sentences: where on the page, what was given, what is allowed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, get_args

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from omnistudy.errors import OmnistudyError, nearest
from omnistudy.registry.field_unit import unit_of
from omnistudy.registry.kinds import BUILT_IN, load_kind

REPEATED_LONGEST = 60
"""Characters of what was given that are repeated."""


class Fault(NamedTuple):
    """One fault: its path on the page, and a sentence that says what is wrong there."""

    path: str
    sentence: str


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
    return tuple(f"{where}: {fault.path}: {fault.sentence}" for fault in faults(error, model, tree))


def faults(error: ValidationError, model: type[BaseModel], tree: Any) -> tuple[Fault, ...]:
    """Give every fault with its path, walking through the models that kinds select."""
    found = []
    for detail in error.errors(include_url=False):
        place = _place(detail["loc"], model, tree)
        found.append(Fault(place.path or "the whole page", _sentence(detail, place)))
    return tuple(found)


def _sentence(fault: ErrorDetails, place: _Place) -> str:
    if fault["type"] == "extra_forbidden":
        keys = list(dict.fromkeys(key for model in place.around for key in model.model_fields))
        hint = nearest(str(fault["loc"][-1]), keys)
        return f"unknown key; the keys here are {', '.join(keys)}{hint}"
    if fault["type"] == "missing":
        return "is missing and has no default"
    if fault["type"].startswith("kind_"):
        return fault["msg"]
    if fault["type"].startswith("union_tag_"):
        return _untold_which(fault, place)
    given = _shortened(fault["input"])
    if fault["type"] in ("model_type", "dict_type"):
        return f"given {given}, but a mapping of keys is needed"
    reason = fault["msg"].removeprefix("Value error, ").replace("Input should", "it should")
    unit = unit_of(place.field)
    in_unit = f" (in {unit})" if unit and f" in {unit}" not in reason else ""
    return f"given {given}, but {reason}{in_unit}"


def _untold_which(fault: ErrorDetails, place: _Place) -> str:
    """Say what a `kind` or a `shape` may be, where one is wrong or missing."""
    key = fault["ctx"]["discriminator"].strip("'")
    models = models_in(place.field.annotation if place.field else None)
    allowed = list(dict.fromkeys(str(model.model_fields[key].default) for model in models))
    if fault["type"] == "union_tag_not_found":
        return f"'{key}' is missing: it is one of {', '.join(allowed)}"
    tag = fault["ctx"]["tag"]
    return f"unknown {key} '{tag}': it is one of {', '.join(allowed)}{nearest(tag, allowed)}"


def _place(steps: Sequence[str | int], model: type[BaseModel], tree: Any) -> _Place:
    """Walk from the root of the page to a fault along its steps."""
    path: list[str] = []
    around: tuple[type[BaseModel], ...] = (model,)
    models = around
    field: FieldInfo | None = None
    value = tree
    for step in steps:
        tagged = tuple(found for found in models if _tag(found) == step)
        if tagged and not (isinstance(value, Mapping) and step in value):
            models = around = tagged
            continue
        value = _inside(value, step)
        path.append(_label(step, value))
        if isinstance(step, str):
            around = models
            field = next((m.model_fields[step] for m in models if step in m.model_fields), None)
            models = _selected(step, value) or models_in(field.annotation if field else None)
    return _Place(".".join(path), around, field)


def _inside(value: Any, step: str | int) -> Any:
    try:
        return value[step]
    except (KeyError, IndexError, TypeError):
        return None


def _label(step: str | int, value: Any) -> str:
    """Call an item of a list by its name where it has one, else by its place from 1."""
    if isinstance(step, str):
        return step
    named = value if isinstance(value, Mapping) else {}
    return str(named.get("name") or named.get("factor") or step + 1)


def _selected(key: str, value: Any) -> tuple[type[BaseModel], ...]:
    """Give the model that the `kind` under a key such as `law` selects."""
    if f"{key}s" not in BUILT_IN or not isinstance(value, Mapping):
        return ()
    try:
        return (load_kind(f"{key}s", str(value.get("kind"))),)
    except OmnistudyError:
        return ()


def models_in(annotation: Any) -> tuple[type[BaseModel], ...]:
    """Give the models that a field's type names, inside unions and tuples too."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return (annotation,)
    return tuple(model for part in get_args(annotation) for model in models_in(part))


def _tag(model: type[BaseModel]) -> Any:
    """Give what pydantic puts on the path for one member of a tagged union."""
    for key in ("kind", "shape"):
        if key in model.model_fields:
            return model.model_fields[key].default
    return None


def _shortened(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= REPEATED_LONGEST else f"{text[:REPEATED_LONGEST]}..."
