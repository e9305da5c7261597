"""What may be chosen: kinds and the pages of conf, each in a line."""

from __future__ import annotations

import re
from inspect import getdoc
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from omnistudy.errors import UnknownKind
from omnistudy.errors.registry import PageOfUnknownKind, UnknownKindOrPage
from omnistudy.registry.conf import conf_roots
from omnistudy.registry.kinds import kinds, load_kind

NOT_READABLE = "(not readable as YAML)"
_COMMENT = re.compile(r"(?:^|\s)#\s*(.+)$", re.MULTILINE)


class Entry(NamedTuple):
    """A kind, the first paragraph of its docstring, and the package it comes from."""

    kind: str
    summary: str
    package: str


class Page(NamedTuple):
    """A YAML page of a group.

    kind : None for a page that names none of its own.
    summary : its first comment, "" for a page without one.
    sets : dotted name and value of what it sets.
    """

    name: str
    kind: str | None
    summary: str
    file: Path
    sets: tuple[tuple[str, Any], ...]


class Found(NamedTuple):
    """What a name stands for in a group: a kind, and the page of that name where there is one."""

    entry: Entry
    page: Page | None


def entries(group: str) -> tuple[Entry, ...]:
    """List every kind of a group ("laws"), ours and installed packages'; raises BrokenKind."""
    return tuple(entry(group, kind) for kind in kinds(group))


def entry(group: str, kind: str) -> Entry:
    """Give the entry of one kind; raises UnknownKind or BrokenKind."""
    chosen = load_kind(group, kind)
    summary = (getdoc(chosen) or "").partition("\n\n")[0]
    return Entry(kind, " ".join(summary.split()), chosen.__module__.partition(".")[0])


def pages(group: str, lab: Path | None = None) -> tuple[Page, ...]:
    """List the pages of a group ("laws" stand in `law/`); the lab's hide ours of the same name."""
    folder = group.removesuffix("s")
    files: dict[str, Path] = {}
    for root in conf_roots(lab):
        for file in sorted((root / folder).glob("*.yaml")):
            files.setdefault(file.stem, file)
    return tuple(_page(name, file) for name, file in sorted(files.items()))


def names(group: str, lab: Path | None = None) -> tuple[str, ...]:
    """Name every kind and every page of a group."""
    return tuple(sorted({*kinds(group), *(page.name for page in pages(group, lab))}))


def find(group: str, name: str, lab: Path | None = None) -> Found:
    """Give what a name stands for: a page and its kind, else a kind alone.

    Raises UnknownKindOrPage with the nearest name, PageOfUnknownKind, or BrokenKind.
    """
    page = next((page for page in pages(group, lab) if page.name == name), None)
    kind = (page.kind if page else None) or name
    try:
        return Found(entry(group, kind), page)
    except UnknownKind as fault:
        if page is not None and page.kind is not None:
            raise PageOfUnknownKind(page.file, page.kind, group, kinds(group)) from fault
        raise UnknownKindOrPage(group, name, names(group, lab)) from fault


def _page(name: str, file: Path) -> Page:
    try:
        text = file.read_text(encoding="utf-8")
        tree = yaml.safe_load(text)
    except (yaml.YAMLError, UnicodeDecodeError):
        return Page(name, None, NOT_READABLE, file, ())
    comment = _COMMENT.search(text)
    tree = tree if isinstance(tree, dict) else {}
    sets = tuple((key, value) for key, value in _flat(tree, "") if key not in ("kind", "defaults"))
    kind = tree.get("kind")
    return Page(name, kind and str(kind), comment[1].strip(" :") if comment else "", file, sets)


def _flat(tree: dict[Any, Any], prefix: str) -> list[tuple[str, Any]]:
    found = []
    for key, value in tree.items():
        if isinstance(value, dict):
            found += _flat(value, f"{prefix}{key}.")
        else:
            found.append((f"{prefix}{key}", value))
    return found
