"""Parts of a set-up by the names of their pages, for driving without a protocol."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from omnistudy.errors.drive import BrokenPart, UnknownPart
from omnistudy.protocol.page import composed
from omnistudy.registry import load_kind
from omnistudy.registry.conf import conf_roots
from omnistudy.registry.faults import explain
from omnistudy.tasks import Messages


def part(group: str, name: str, lab: Path | None = None) -> Any:
    """Give the part that a page of `conf` says, such as page "component" of group "law".

    The lab's folder is asked first. Raises UnknownPart, BrokenPart, ProtocolFaults, UnknownKind.
    """
    roots = conf_roots(lab)
    names = part_names(group, lab)
    if name not in names:
        raise UnknownPart(group, name, names)
    tree = composed(f"{group}/{name}", roots, (), ()).get(group)
    model = Messages if group == "messages" else _model(group, tree)
    try:
        return model.model_validate(tree)
    except ValidationError as error:
        raise BrokenPart(explain(error, model, tree, f"conf/{group}/{name}.yaml")) from error


def part_names(group: str, lab: Path | None = None) -> tuple[str, ...]:
    """Name every page of a group, in the lab's folder and in ours."""
    pages = (page for root in conf_roots(lab) for page in (root / group).glob("*.yaml"))
    return tuple(sorted({page.stem for page in pages}))


def _model(group: str, tree: Any) -> type[BaseModel]:
    kind = tree.get("kind") if isinstance(tree, dict) else None
    model: type[BaseModel] = load_kind(f"{group}s", str(kind))
    return model
