"""Write docs/reference/protocol.md from the models of a protocol: `make reference`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal, NamedTuple, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt, MaxLen, MinLen
from pydantic import BaseModel, PlainValidator
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from omnistudy.protocol import Protocol
from omnistudy.registry import load_kind
from omnistudy.registry.field_unit import metadata_of, unit_of
from omnistudy.registry.kinds import BUILT_IN

PAGE = Path(__file__).parent / "reference" / "protocol.md"
HEAD = """\
# The keys of a protocol

A protocol is one YAML page, such as `protocols/utah2017_component.yaml`. `make reference` writes
this list of its keys from the models that read them; a test tells when it is stale.

- `defaults` is Hydra's list of pages to begin with: `- law: component` takes `law/component.yaml`
  from your lab's folder (`--conf` or `OMNISTUDY_CONF`) if it is there, else ours. A protocol may
  begin with another one (`- utah2017_component`). The last line is `- _self_`.
- A page writes only what differs from the defaults below. A number has no unit behind it: it is
  always in the unit that stands here.
- `factors` is a mapping from a factor's name to its levels; `conditions` one from a condition's
  name to its `masked_label`, its `levels` (a mapping from factor to level) and what differs from
  the parts of the page (`world`, `plant`, `device`, `controller`, `law`, `operator`, `task`).
  What a condition writes is laid over the part; another `kind` replaces the part whole.
- On the command line `law=none` takes another page of a group, `law.compliance_centre=0.1` sets a
  value: `omnistudy protocol show utah2017_component participants.count=4`.
- An installed package adds kinds of its own through the entry points `omnistudy.laws`,
  `omnistudy.plants` and so on; `protocol check` names those that are there.
"""
AS_WRITTEN = {
    "factors[].levels": "factors.NAME",
    "conditions[].levels[].level": "conditions.NAME.levels.FACTOR",
    "conditions[]": "conditions.NAME",
}
"""Keys of the models, and what stands for them on the page."""

NAMES_OF_MAPPINGS = ("factors[].name", "conditions[].name", "conditions[].levels[].factor")
"""Keys that nobody writes: they are the names in the mappings."""

COLUMNS = ("key", "what", "unit", "bounds", "default", "meaning")


class Row(NamedTuple):
    """One key: its dotted path, what it takes, unit, bounds, default and meaning."""

    key: str
    what: str
    unit: str
    bounds: str
    default: str
    meaning: str


def rows(model: type[BaseModel], prefix: str = "", default: object = None) -> Iterator[Row]:
    """Give a row for every key of a model, nested ones too; kinds are left to their own table."""
    for name, field in model.model_fields.items():
        value = getattr(default, name, field.get_default(call_default_factory=True))
        inside = [] if _picks_a_kind(field) else _models(field.annotation)
        key = f"{prefix}{name}"
        if key in NAMES_OF_MAPPINGS:
            continue
        if not inside:
            yield _row(key, field, value)
        elif len(inside) == 1:
            several = get_origin(field.annotation) is tuple
            below = f"{key}[]." if several else f"{key}."
            yield from rows(inside[0], below, None if several else value)
        else:
            for alternative in inside:
                own = value if isinstance(value, alternative) else None
                yield from rows(alternative, f"{key} ({_tag(alternative)}).", own)


def page() -> str:
    """Give the page's text."""
    parts = [HEAD, "## The page itself\n", *_table(Protocol)]
    for group, kinds in BUILT_IN.items():
        for kind in kinds:
            chosen = load_kind(group, kind)
            summary = (chosen.__doc__ or "").strip().splitlines()[0]
            parts += [f"## {group}: `{kind}`\n", f"{summary}\n", *_table(chosen)]
    return "\n".join(parts)


def _table(model: type[BaseModel]) -> Iterator[str]:
    yield f"| {' | '.join(COLUMNS)} |"
    yield f"|{' --- |' * len(COLUMNS)}"
    for row in rows(model):
        cells = (cell.replace("|", "\\|").replace("\n", " ") for cell in row)
        yield f"| {' | '.join(cells)} |".replace("|  |", "| |").replace("|  |", "| |")
    yield ""


def _row(key: str, field: FieldInfo, default: object) -> Row:
    unit = unit_of(field)
    return Row(
        key=f"`{_as_written(key)}`",
        what=_part(field) if _picks_a_kind(field) else _what(field.annotation),
        unit="" if unit == "1" else unit,
        bounds=", ".join(_bounds(field)),
        default="required" if default is PydanticUndefined else f"`{_text(default)}`",
        meaning=" ".join((field.description or "").split()),
    )


def _as_written(key: str) -> str:
    """Give a key as people write it; names come as keys of mappings there."""
    for read, written in AS_WRITTEN.items():
        key = key.replace(read, written)
    return key


def _picks_a_kind(field: FieldInfo) -> bool:
    return any(isinstance(item, PlainValidator) for item in metadata_of(field))


def _part(field: FieldInfo) -> str:
    return f"a kind of {_models(field.annotation)[0].__name__.lower()}s, below"


def _what(annotation: Any) -> str:
    if get_origin(annotation) is Literal:
        return " or ".join(f"`{value}`" for value in get_args(annotation))
    inner = [part for part in get_args(annotation) if part not in (type(None), Ellipsis)]
    if get_origin(annotation) is tuple:
        return f"list of {_what(inner[0])}" if len(set(map(str, inner))) == 1 else "list"
    if inner:
        return _what(inner[0])
    return {float: "number", int: "whole number", bool: "true or false", str: "text"}.get(
        annotation, "list" if annotation is tuple else "text"
    )


def _bounds(field: FieldInfo) -> Iterator[str]:
    for item in metadata_of(field):
        match item:
            case Gt(gt=bound):
                yield f"> {bound:g}"
            case Ge(ge=bound):
                yield f">= {bound:g}"
            case Lt(lt=bound):
                yield f"< {bound:g}"
            case Le(le=bound):
                yield f"<= {bound:g}"
            case MinLen(min_length=length):
                yield f"at least {length}"
            case MaxLen(max_length=length):
                yield f"at most {length} long"
        if pattern := getattr(item, "pattern", None):
            yield f"`{pattern}`"


def _text(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, tuple):
        return f"[{', '.join(_text(item) for item in value)}]"
    if value is None:
        return "null"
    return str(value).lower() if isinstance(value, bool) else str(value) or "''"


def _models(annotation: Any) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in _models(part)]


def _tag(model: type[BaseModel]) -> str:
    return next(
        str(model.model_fields[key].default)
        for key in ("kind", "shape")
        if key in model.model_fields
    )


if __name__ == "__main__":
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(page(), encoding="utf-8")
