"""The parameters of a kind: what they are, and how settings typed by a person change them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import yaml
from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails, PydanticUndefined

from omnistudy.errors.parameters import BadParameter, NotASetting, UnknownParameter
from omnistudy.registry.faults import Fault, faults, models_in
from omnistudy.registry.field_unit import unit_of
from omnistudy.registry.kinds import load_kind
from omnistudy.registry.model import KindModel


class Parameter(NamedTuple):
    """One number or word of a kind.

    name : dotted path, as `--set` takes it.
    default : None too when it must be given.
    unit : "" for what has none.
    meaning : first sentence or sentences of its docstring.
    required : whether it must be given.
    """

    name: str
    default: Any
    unit: str
    meaning: str
    required: bool = False


def parameters(kind_class: type[BaseModel]) -> tuple[Parameter, ...]:
    """List the parameters of a kind, nested ones by dotted path, without `kind` itself.

    Where a field may hold one of several kinds, which one is a parameter too.
    """
    return tuple(_parameters(kind_class, ""))


def _parameters(
    model: type[BaseModel], prefix: str, made: BaseModel | None = None
) -> Iterator[Parameter]:
    """List a model's parameters with its own defaults, or with what one that is made holds."""
    for name, field in model.model_fields.items():
        default = _default(field) if made is None else getattr(made, name)
        if isinstance(default, KindModel) and len(models_in(field.annotation)) > 1:
            yield from _alternatives(field, default, f"{prefix}{name}.")
        elif isinstance(default, BaseModel):
            yield from _parameters(type(default), f"{prefix}{name}.", default)
        elif name != "kind":
            meaning = " ".join((field.description or "").split())
            required = field.is_required() and made is None
            yield Parameter(prefix + name, default, unit_of(field), meaning, required)


def _alternatives(field: FieldInfo, default: KindModel, prefix: str) -> Iterator[Parameter]:
    """List which kind a field holds, and the parameters of the default's kind before others'."""
    models = sorted(models_in(field.annotation), key=lambda model: not isinstance(default, model))
    named = [str(model.model_fields["kind"].default) for model in models]
    yield Parameter(f"{prefix}kind", default.kind, "", f"One of {', '.join(named)}.", False)
    for name, model in zip(named, models, strict=True):
        chosen = name == default.kind
        for row in _parameters(model, prefix, default if chosen else None):
            meaning = row.meaning if chosen else f"Of kind {name}. {row.meaning}"
            yield row._replace(meaning=meaning, required=row.required and chosen)


def _default(field: FieldInfo) -> Any:
    default = field.get_default(call_default_factory=True, validated_data={})
    return None if default is PydanticUndefined else default


def make_kind(group: str, kind: str, settings: Sequence[str] = ()) -> Any:
    """Make a kind with its defaults changed by settings such as "boundary.layer_x=0.2".

    Raises UnknownKind, NotASetting, UnknownParameter with the nearest name, and BadParameter.
    """
    chosen = load_kind(group, kind)
    values: dict[str, Any] = {"kind": kind}
    for name, text in sorted(map(_split, settings), key=lambda setting: not _picks(setting[0])):
        _put(values, name, _parsed(text), chosen, kind)
    try:
        return chosen.model_validate(values)
    except ValidationError as refused:
        told = zip(refused.errors(), faults(refused, chosen, values), strict=True)
        raise BadParameter(kind, [_sentence(*both) for both in told]) from None


def _split(setting: str) -> tuple[str, str]:
    name, equals, text = setting.partition("=")
    if not name or not equals:
        raise NotASetting(setting)
    return name.strip(), text


def _picks(name: str) -> bool:
    return name.endswith(".kind")


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
    if _picks(name) and value != values["kind"]:
        values.clear()
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


def _sentence(error: ErrorDetails, fault: Fault) -> str:
    if error["type"].startswith(("extra_forbidden", "union_tag_")):
        return f"{fault.path}: {fault.sentence}"
    return f"{fault.path} = {error['input']!r}: {error['msg'].removeprefix('Value error, ')}"
