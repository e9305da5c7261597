"""From a world's name or file to the world."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml
from pydantic import ValidationError

from omnistudy.errors.worlds import BrokenWorld, UnknownWorld
from omnistudy.registry import load_kind
from omnistudy.registry.conf import conf_roots
from omnistudy.registry.faults import explain
from omnistudy.worlds.world import World


def world_names(lab: Path | None = None) -> tuple[str, ...]:
    """Name every world in the lab's folder and in ours."""
    return tuple(
        sorted({page.stem for root in conf_roots(lab) for page in (root / "world").glob("*.yaml")})
    )


def world_file(name_or_file: str | Path, lab: Path | None = None) -> Path:
    """Give the YAML page of a world: a path that exists, else a name in conf/world.

    The lab's folder is asked first. Raises UnknownWorld.
    """
    given = str(name_or_file)
    if Path(given).is_file():
        return Path(given)
    for root in conf_roots(lab):
        page = root / "world" / f"{given}.yaml"
        if page.is_file():
            return page
    raise UnknownWorld(given, world_names(lab))


def load_world(name_or_file: str | Path, lab: Path | None = None) -> World:
    """Read a world; raises UnknownWorld, BrokenWorld, or UnknownKind."""
    page = world_file(name_or_file, lab)
    data = _parsed(page)
    kind = data.get("kind", "plan") if isinstance(data, dict) else "plan"
    chosen: type[World] = load_kind("worlds", str(kind))
    try:
        return chosen.model_validate(data)
    except ValidationError as faults:
        raise BrokenWorld(page, explain(faults, chosen, data, str(page))) from faults


def _parsed(page: Path) -> Any:
    try:
        return yaml.safe_load(page.read_text(encoding="utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError) as cause:
        mark = getattr(cause, "problem_mark", None)
        line = f", line {mark.line + 1}" if mark else ""
        problem = getattr(cause, "problem", None) or str(cause).splitlines()[0]
        raise BrokenWorld(page, (f"{page}{line}: not readable as YAML ({problem})",)) from cause
