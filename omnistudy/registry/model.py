"""The frozen parameter model under every kind, and the field type that picks the class."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Self

from pydantic import BaseModel, ConfigDict, PlainValidator, model_validator
from pydantic_core import PydanticCustomError

from omnistudy.errors import UnknownKind, nearest
from omnistudy.registry.kinds import kinds, load_kind


class Model(BaseModel):
    """Frozen data from a YAML page: unknown keys are refused, defaults stand in the class."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, use_attribute_docstrings=True, validate_default=True
    )

    @model_validator(mode="before")
    @classmethod
    def _keep_what_is_left_out(cls, given: Any) -> Any:
        """Lay a mapping over the default of its field, so that what it leaves out stays.

        Without this `boundary: {layer_x: 0.2}` would put a law back to another robot's boundary
        wherever the law's default is not the boundary's own.
        """
        if not isinstance(given, dict):
            return given
        fields = cls.model_fields
        return {
            name: _laid_over(fields[name].default, part) if name in fields else part
            for name, part in given.items()
        }

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Give a copy with some fields changed; raises ValidationError.

        Unlike pydantic's own, the copy is validated, and forgets what cached properties remember.
        """
        source = super().model_copy(deep=deep)
        given = {name: getattr(source, name) for name in self.model_fields_set}
        return type(self).model_validate({**given, **(update or {})})


def _laid_over(default: Any, given: Any) -> Any:
    """Lay a mapping over what a default was made with; another kind replaces it whole."""
    if not isinstance(given, dict) or not isinstance(default, Model):
        return given
    kind = getattr(default, "kind", None)
    if given.get("kind", kind) != kind:
        return given
    made_with = {name: getattr(default, name) for name in default.model_fields_set}
    if kind is not None:
        made_with["kind"] = kind
    return made_with | {name: _laid_over(made_with.get(name), part) for name, part in given.items()}


class KindModel(Model):
    """A model that a `kind:` selects; a subclass gives `kind: Literal["name"] = "name"`."""

    kind: str


def kind_validator(group: str) -> PlainValidator:
    """Validate a mapping by the class that its `kind` names in the group."""

    def validate(value: Any) -> Any:
        if isinstance(value, KindModel):
            return value
        if not isinstance(value, dict) or not isinstance(value.get("kind"), str):
            raise PydanticCustomError(
                "kind_missing",
                "a mapping with 'kind' is needed; the kinds of {group} are {allowed}",
                {"group": group, "allowed": ", ".join(kinds(group))},
            )
        try:
            chosen = load_kind(group, value["kind"])
        except UnknownKind:
            raise PydanticCustomError(
                "kind_unknown",
                "unknown kind '{given}': the kinds of {group} are {allowed}{hint}",
                {
                    "given": value["kind"],
                    "group": group,
                    "allowed": ", ".join(kinds(group)),
                    "hint": nearest(value["kind"], kinds(group)),
                },
            ) from None
        return chosen.model_validate(value)

    return PlainValidator(validate)
