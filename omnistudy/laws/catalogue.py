"""Which laws there are, each in a line."""

from __future__ import annotations

from inspect import getdoc
from typing import NamedTuple

from omnistudy.registry import kinds, load_kind


class Entry(NamedTuple):
    """A law's kind, the first sentence of its docstring, and the package it comes from."""

    kind: str
    summary: str
    package: str


def catalogue() -> tuple[Entry, ...]:
    """List every law, ours and those of installed packages; raises BrokenKind."""
    return tuple(entry(kind) for kind in kinds("laws"))


def entry(kind: str) -> Entry:
    """Give the entry of one law; raises UnknownKind or BrokenKind."""
    law = load_kind("laws", kind)
    summary = (getdoc(law) or "").partition("\n\n")[0]
    return Entry(kind, " ".join(summary.split()), law.__module__.partition(".")[0])
