"""A world as a YAML page."""

from __future__ import annotations

from pathlib import Path

import yaml

from omnistudy.errors.worlds import WorldExists, WorldNotWritten
from omnistudy.worlds.world import World


def write_world(world: World, file: Path, *, replace: bool = False) -> None:
    """Write a world's page, what is left at its default left out.

    Raises WorldExists unless `replace`, or WorldNotWritten.
    """
    if file.exists() and not replace:
        raise WorldExists(file)
    tree = {"kind": world.kind} | world.model_dump(mode="json", exclude_defaults=True)
    for body in tree.get("bodies", ()):
        body["geometry"] = {"shape": _shape(body["geometry"]), **body["geometry"]}
        if "motion" in body:
            body["motion"] = {"kind": _motion(body["motion"]), **body["motion"]}
    text = yaml.safe_dump(tree, sort_keys=False, allow_unicode=True, default_flow_style=None)
    draft = file.with_name(f".{file.name}.part")
    try:
        draft.write_text(text, encoding="utf-8")
        draft.replace(file)
    except OSError as refused:
        raise WorldNotWritten(file, refused.strerror or str(refused)) from refused


def _motion(motion: dict[str, object]) -> str:
    return "timetable" if "stops" in motion else "patrol"


def _shape(geometry: dict[str, float]) -> str:
    return "cylinder" if "radius" in geometry else "box"
