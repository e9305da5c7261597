"""Which names a new thing may have."""

from __future__ import annotations

from keyword import iskeyword
from pathlib import Path

import yaml
from pydantic import TypeAdapter, ValidationError

from omnistudy.errors.lab import BadName, TakenName
from omnistudy.laws import WrenchLaw
from omnistudy.protocol.compose import protocol_pages
from omnistudy.registry.catalogue import names
from omnistudy.registry.name import Name
from omnistudy.survey import instrument_names
from omnistudy.worlds import world_names


def check_name(noun: str, name: str, lab: Path | None) -> None:
    """Refuse what cannot be a name, and what a thing of this noun is called already.

    lab : folder whose pages count as well; None asks OMNISTUDY_CONF. Raises BadName or TakenName.
    """
    try:
        TypeAdapter(Name).validate_python(name)
    except ValidationError:
        raise BadName(
            name, "write small letters, digits and underscores, a letter first, 60 at most"
        ) from None
    if iskeyword(name):
        raise BadName(name, "it is a word of Python itself, so choose another")
    if yaml.safe_load(name) != name:
        raise BadName(name, f"YAML reads it as {yaml.safe_load(name)}, so choose another")
    if noun == "law" and class_name(noun, name) == WrenchLaw.__name__:
        raise BadName(name, "its class would be WrenchLaw, which it extends, so choose another")
    if name in _taken(noun, lab):
        raise TakenName(noun, name)


def _taken(noun: str, lab: Path | None) -> tuple[str, ...]:
    if noun == "world":
        return world_names(lab)
    if noun == "protocol":
        return tuple(protocol_pages(lab))
    if noun == "survey":
        return instrument_names(lab)
    return names(f"{noun}s", lab)


def class_name(noun: str, name: str) -> str:
    """Give the class of a kind: "soft_wall" of "law" is SoftWallLaw."""
    return "".join(part.capitalize() for part in name.split("_")) + noun.capitalize()
