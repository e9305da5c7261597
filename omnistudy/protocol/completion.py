"""From the short form that people write to the complete one that models read."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from itertools import product
from typing import Any

PARTS = ("world", "plant", "device", "controller", "law", "operator", "task")
"""Keys under which a condition may differ from its protocol."""

Page = Callable[[str, str], Any]
"""Gives the content of a page by group and name, such as ("law", "none")."""


def completed(tree: Mapping[str, Any], page: Page) -> dict[str, Any]:
    """Turn mappings into lists, cells of factors into conditions, conditions into complete ones.

    A condition's part is laid over its levels' parts and those over the protocol's; another `kind`
    replaces it whole, a word stands for the page of that name. What is not shaped as expected is
    left for the models to refuse.
    """
    full = dict(tree)
    factors = full.get("factors")
    if isinstance(factors, Mapping):
        full["factors"] = [_factor(name, body) for name, body in factors.items()]
        if full.get("conditions") is None:
            full["conditions"] = _cells(factors)
    if isinstance(full.get("conditions"), Mapping):
        conditions = full["conditions"].items()
        full["conditions"] = [_condition(str(n), body, tree, page) for n, body in conditions]
    if isinstance(full.get("participants"), Mapping):
        full["participants"] = _listed(full["participants"], "strata")
    if isinstance(full.get("visits"), Mapping):
        full["visits"] = [
            {"name": name, **_visit(body)} if isinstance(body, Mapping) else body
            for name, body in full["visits"].items()
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


def _factor(name: str, body: Any) -> Any:
    """Read a factor; a list is short for the levels of one within participants."""
    if not isinstance(body, Mapping):
        return {"name": name, "levels": body}
    levels = body.get("levels")
    return {"name": name, **body, "levels": list(levels) if isinstance(levels, Mapping) else levels}


def _cells(factors: Mapping[str, Any]) -> dict[str, Any]:
    """Make a condition of every combination of levels, named after them."""
    levels = {name: _levels_of(body) for name, body in factors.items()}
    cells = [
        dict(zip(levels, cell, strict=True)) for cell in product(*(levels[name] for name in levels))
    ]
    return {
        _cell_name(cell): {"masked_label": _label(index), "levels": cell}
        for index, cell in enumerate(cells)
    }


def _levels_of(factor: Any) -> list[Any]:
    levels = factor.get("levels") if isinstance(factor, Mapping) else factor
    return list(levels) if isinstance(levels, Mapping | list) else []


def _cell_name(cell: Mapping[str, Any]) -> str:
    return "_".join(_word(factor, str(level)) for factor, level in cell.items())


def _word(factor: str, level: str) -> str:
    """Make a level part of a name; a number takes its factor's name along."""
    text = re.sub(r"^-", "minus_", level.lower())
    word = re.sub(r"[^a-z0-9]+", "_", text).strip("_")
    return word if re.match(r"(?!minus_)[a-z]", word) else f"{factor}_{word}"


def _label(index: int) -> str:
    """Give A to Z, then AA to AZ, and so on."""
    before, last = divmod(index, 26)
    return (_label(before - 1) if before else "") + chr(ord("A") + last)


def _condition(name: str, body: Any, tree: Mapping[str, Any], page: Page) -> Any:
    if not isinstance(body, Mapping):
        return body
    full = {"name": name, **body}
    changes = [body]
    if isinstance(full.get("levels"), Mapping):
        factors = tree.get("factors")
        changes = [*_level_parts(full["levels"], factors), body]
        full["levels"] = _levels(full["levels"], factors)
        for change in changes:
            full |= {key: value for key, value in change.items() if key not in {*PARTS, "levels"}}
    for part in PARTS:
        given = [change[part] for change in changes if part in change]
        if given:
            full[part] = tree.get(part)
        for change in given:
            whole = page(part, change) if isinstance(change, str) else change
            full[part] = whole if isinstance(change, str) else laid_over(full[part], whole)
    return full


def _level_parts(levels: Mapping[str, Any], factors: Any) -> list[Mapping[str, Any]]:
    """Give what a condition's levels change, in the order of the factors."""
    found = []
    for name, body in factors.items() if isinstance(factors, Mapping) else ():
        bodies = body.get("levels") if isinstance(body, Mapping) else None
        if not isinstance(bodies, Mapping) or name not in levels:
            continue
        change = bodies.get(levels[name])
        if isinstance(change, Mapping):
            found.append(change)
    return found


def _levels(levels: Mapping[str, Any], factors: Any) -> list[dict[str, Any]]:
    """List levels in the order of the factors, so that the page's order says nothing."""
    known = [name for name in factors if name in levels] if isinstance(factors, Mapping) else []
    return [{"factor": name, "level": levels[name]} for name in dict.fromkeys([*known, *levels])]


def _visit(body: Mapping[str, Any]) -> dict[str, Any]:
    full = dict(body)
    if isinstance(full.get("blocks"), list):
        full["blocks"] = [
            {**block, "only": _levels(block["only"], None)}
            if isinstance(block, Mapping) and isinstance(block.get("only"), Mapping)
            else block
            for block in full["blocks"]
        ]
    return full


def _listed(body: Mapping[str, Any], key: str) -> dict[str, Any]:
    """Turn a mapping from names into a list of named things; a number is their count."""
    full = dict(body)
    if isinstance(full.get(key), Mapping):
        full[key] = [
            {"name": name, **value}
            if isinstance(value, Mapping)
            else {"name": name, "count": value}
            for name, value in full[key].items()
        ]
    return full
