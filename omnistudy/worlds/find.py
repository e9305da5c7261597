"""From a world's name or file to the world."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from omnistudy.errors.worlds import BrokenWorld, UnknownWorld
from omnistudy.registry import load_kind
from omnistudy.registry.faults import explain
from omnistudy.registry.pages import page_content, page_file, page_names
from omnistudy.worlds.world import World


def world_names(lab: Path | None = None) -> tuple[str, ...]:
    """Name every world in the lab's folder and in ours."""
    return page_names("world", lab)


def world_file(name_or_file: str | Path, lab: Path | None = None) -> Path:
    """Give the YAML page of a world: a path that exists, else a name in conf/world.

    The lab's folder is asked first. Raises UnknownWorld.
    """
    page = page_file("world", name_or_file, lab)
    if page is None:
        raise UnknownWorld(str(name_or_file), world_names(lab))
    return page


def load_world(name_or_file: str | Path, lab: Path | None = None) -> World:
    """Read a world; raises UnknownWorld, BrokenWorld, or UnknownKind."""
    page = world_file(name_or_file, lab)
    data = page_content(page, BrokenWorld)
    kind = data.get("kind", "plan") if isinstance(data, dict) else "plan"
    chosen: type[World] = load_kind("worlds", str(kind))
    try:
        return chosen.model_validate(data)
    except ValidationError as faults:
        raise BrokenWorld(page, explain(faults, chosen, data, str(page))) from faults
