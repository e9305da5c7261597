"""From the short form that people write to the complete one that models read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

PARTS = ("world", "plant", "device", "controller", "law", "operator", "task")
"""Keys under which a condition may differ from its protocol."""


def completed(tree: Mapping[str, Any]) -> dict[str, Any]:
    """Turn factors, conditions and levels from mappings into lists, conditions made complete.

    A condition's part is laid over the protocol's; another `kind` replaces it whole. What is not
    shaped as expected is left for the models to refuse.
    """
    full = dict(tree)
    if isinstance(full.get("factors"), Mapping):
        full["factors"] = [
            {"name": name, "levels": levels} for name, levels in full["factors"].items()
        ]
    if isinstance(full.get("conditions"), Mapping):
        full["conditions"] = [
            _condition(str(name), body, tree) for name, body in full["conditions"].items()
        ]
    return full


def laid_over(base: Any, change: Any) -> Any:
    """Lay a change over a mapping, at every depth; another `kind` replaces the mapping whole."""
    if not isinstance(base, Mapping) or not isinstance(change, Mapping):
        return change
    if change.get("kind", base.get("kind")) != base.get("kind"):
        return dict(change)
    return dict(base) | {
        key: laid_over(base[key], value) if key in base else value for key, value in change.items()
    }


def _condition(name: str, body: Any, tree: Mapping[str, Any]) -> Any:
    if not isinstance(body, Mapping):
        return body
    full = {"name": name, **body}
    if isinstance(full.get("levels"), Mapping):
        full["levels"] = _levels(full["levels"], tree.get("factors"))
    for part in PARTS:
        if part in full:
            full[part] = laid_over(tree.get(part), full[part])
    return full


def _levels(levels: Mapping[str, Any], factors: Any) -> list[dict[str, Any]]:
    """List levels in the order of the factors, so that the page's order says nothing."""
    known = [name for name in factors if name in levels] if isinstance(factors, Mapping) else []
    return [{"factor": name, "level": levels[name]} for name in dict.fromkeys([*known, *levels])]
