"""The parameters of a kind: what they are, and how settings typed by a person change them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import yaml
from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails, PydanticUndefined

from omnistudy.errors.parameters import BadParameter, NotASetting, UnknownParameter
from omnistudy.registry.field_unit import unit_of
from omnistudy.registry.kinds import load_kind


class Parameter(NamedTuple):
    """One number or word of a kind.

    name : dotted path, as `--set` takes it.
    default : None when it must be given.
    unit : "" for what has none.
    meaning : first sentence or sentences of its docstring.
    """

    name: str
    default: Any
    unit: str
    meaning: str


def parameters(kind_class: type[BaseModel]) -> tuple[Parameter, ...]:
    """List the parameters of a kind, nested ones by dotted path, without `kind` itself."""
    return tuple(_parameters(kind_class, ""))


def _parameters(model: type[BaseModel], prefix: str) -> Iterator[Parameter]:
    for name, field in model.model_fields.items():
        default = _default(field)
        if isinstance(default, BaseModel):
            yield from _parameters(type(default), f"{prefix}{name}.")
        elif name != "kind":
            meaning = " ".join((field.description or "").split())
            yield Parameter(prefix + name, default, unit_of(field), meaning)


def _default(field: FieldInfo) -> Any:
    default = field.get_default(call_default_factory=True, validated_data={})
    return None if default is PydanticUndefined else default


def make_kind(group: str, kind: str, settings: Sequence[str] = ()) -> Any:
    """Make a kind with its defaults changed by settings such as "boundary.layer_x=0.2".

    Raises UnknownKind, NotASetting, UnknownParameter with the nearest name, and BadParameter.
    """
    chosen = load_kind(group, kind)
    values: dict[str, Any] = {}
    for setting in settings:
        name, equals, text = setting.partition("=")
        if not name or not equals:
            raise NotASetting(setting)
        _put(values, name.strip(), _parsed(text), chosen, kind)
    try:
        return chosen.model_validate({"kind": kind, **values})
    except ValidationError as refused:
        raise BadParameter(kind, [_fault(error) for error in refused.errors()]) from None


def _put(values: dict[str, Any], name: str, value: Any, model: type[BaseModel], kind: str) -> None:
    """Lay a value at its dotted place, beside the defaults of the models on the way there."""
    allowed = [parameter.name for parameter in parameters(model)]
    if name not in allowed:
        raise UnknownParameter(kind, name, allowed)
    *parents, last = name.split(".")
    for parent in parents:
        field = model.model_fields[parent]
        default = _default(field)
        values = values.setdefault(parent, default.model_dump())
        model = type(default)
    values[last] = value


def _parsed(text: str) -> Any:
    """Read a word as YAML would, and 1e-3 as the number that people mean by it."""
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError:
        return text
    if isinstance(value, str):
        try:
            return float(value)
        except ValueError:
            return value
    return value


def _fault(error: ErrorDetails) -> str:
    name = ".".join(str(part) for part in error["loc"])
    return f"{name} = {error['input']!r}: {error['msg'].removeprefix('Value error, ')}"
