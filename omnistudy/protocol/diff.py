"""What differs between two frozen protocols, path by path."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any, NamedTuple

SHOWN_LONGEST = 80
"""Characters of a value that one line shows."""


class Difference(NamedTuple):
    """One place where two protocols differ; a value that is not there is None.

    old, new : JSON text.
    """

    path: str
    old: str | None
    new: str | None

    def __str__(self) -> str:
        """Say it in one line; long values are cut."""
        if self.old is None:
            return f"{self.path}: added {_shown(self.new)}"
        if self.new is None:
            return f"{self.path}: taken out, was {_shown(self.old)}"
        return f"{self.path}: {_shown(self.old)} -> {_shown(self.new)}"


def diff(old_json: str, new_json: str) -> tuple[Difference, ...]:
    """Compare two canonical texts.

    Things that have a name are compared by it, not by their place. A part of another kind, or one
    that only one of the two has, is one difference as a whole.
    """
    return tuple(_differences(json.loads(old_json), json.loads(new_json), ""))


def _differences(old: Any, new: Any, path: str) -> Iterator[Difference]:
    if old == new:
        return
    if isinstance(old, dict) and isinstance(new, dict) and old.get("kind") == new.get("kind"):
        for key in dict.fromkeys([*old, *new]):
            inside = f"{path}.{key}" if path else str(key)
            yield from _differences(old.get(key), new.get(key), inside)
    elif _named(old) and _named(new):
        olds, news = ({item["name"]: item for item in items} for items in (old, new))
        yield from _differences(olds, news, path)
        if list(olds) != list(news) and set(olds) == set(news):
            yield Difference(f"{path} (their order)", _text(list(olds)), _text(list(news)))
    else:
        yield Difference(path, _text(old), _text(new))


def _named(items: Any) -> bool:
    if not isinstance(items, list) or not items:
        return False
    names = [item.get("name") for item in items if isinstance(item, dict)]
    return len(names) == len(items) == len(set(names)) and None not in names


def _text(value: Any) -> str | None:
    return None if value is None else json.dumps(value, ensure_ascii=False)


def _shown(text: str | None) -> str:
    if text is None or len(text) <= SHOWN_LONGEST:
        return text or ""
    return f"{text[:SHOWN_LONGEST]}..."
