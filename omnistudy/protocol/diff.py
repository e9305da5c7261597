"""What differs between two frozen protocols, path by path."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any, NamedTuple


class Difference(NamedTuple):
    """One place where two protocols differ; a value that is not there is None.

    old, new : JSON text.
    """

    path: str
    old: str | None
    new: str | None

    def __str__(self) -> str:
        """Say it in one line."""
        if self.old is None:
            return f"{self.path}: added {self.new}"
        if self.new is None:
            return f"{self.path}: taken out, was {self.old}"
        return f"{self.path}: {self.old} -> {self.new}"


def diff(old_json: str, new_json: str) -> tuple[Difference, ...]:
    """Compare two canonical texts; things that have a name are compared by it, not by place."""
    old = dict(_leaves(json.loads(old_json), ""))
    new = dict(_leaves(json.loads(new_json), ""))
    return tuple(
        Difference(path, old.get(path), new.get(path))
        for path in dict.fromkeys([*old, *new])
        if old.get(path) != new.get(path)
    )


def _leaves(tree: Any, path: str) -> Iterator[tuple[str, str]]:
    if isinstance(tree, dict) and tree:
        for key, value in tree.items():
            yield from _leaves(value, f"{path}.{key}" if path else key)
    elif isinstance(tree, list) and _named(tree):
        for item in tree:
            yield from _leaves(item, f"{path}.{item['name']}")
        yield f"{path} (in this order)", json.dumps([item["name"] for item in tree])
    elif isinstance(tree, list) and any(isinstance(item, dict | list) for item in tree):
        for index, item in enumerate(tree, start=1):
            yield from _leaves(item, f"{path}.{index}")
    else:
        yield path, json.dumps(tree, ensure_ascii=False)


def _named(items: list[Any]) -> bool:
    names = [item.get("name") for item in items if isinstance(item, dict)]
    return len(names) == len(items) == len(set(names)) and None not in names
