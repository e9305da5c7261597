"""Which column of a file holds what, as a person types it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from omnistudy.errors.drive import NotAColumn


def mapped(given: Sequence[str], defaults: Mapping[str, str | None]) -> tuple[str | None, ...]:
    """Lay "what=name" over the defaults; names in the order of the defaults, "none" for no column.

    Raises NotAColumn.
    """
    names = dict(defaults)
    for text in given:
        what, equals, name = (word.strip() for word in text.partition("="))
        if what not in defaults or not equals or not name:
            raise NotAColumn(text, list(defaults))
        names[what] = None if name == "none" else name
    return tuple(names.values())
