"""What each value changes in the protocol, without composing the whole page for every point."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from omnistudy.protocol import FrozenProtocol, Protocol, freeze, thaw
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session.sweep.question import Change
from omnistudy.session.sweep.variables import Interval, Swept, override_text

Paths = tuple[tuple[str | int, ...], ...]


@dataclass(frozen=True)
class Composer:
    """Composes the page with some values on top of what holds for every point."""

    page: str | Path
    overrides: tuple[str, ...]

    def protocol(self, values: Mapping[str, Any]) -> Protocol:
        """Give the protocol at these values; raises ProtocolFaults."""
        texts = [override_text(key, value) for key, value in values.items()]
        return compose_protocol(self.page, (*self.overrides, *texts))


class Effects:
    """Knows for every value which places of the canonical tree it changes.

    A page is slow to compose. So a variable is composed at both ends; where a value only stands in
    the same places of the tree, it is put there directly, else every value is composed by itself.
    When the changes of two variables could meddle with each other, every point is composed.
    """

    def __init__(self, composer: Composer, base: Protocol, swept: Sequence[Swept]) -> None:
        self._composer = composer
        self._tree = canonical_tree(freeze(base))
        self._swept = {one.variable.key: one for one in swept}
        self._known: dict[str, tuple[Change, ...]] = {}
        self._places = {key: self._direct(one) for key, one in self._swept.items()}
        self._separable = self._are_separable()

    def changes(self, values: Mapping[str, Any]) -> tuple[Change, ...]:
        """Give what a point changes in the base; raises ProtocolFaults."""
        if self._separable:
            return tuple(change for item in values.items() for change in self._one(*item))
        return self._composed(values)

    def ends(self, key: str) -> tuple[Protocol, ...]:
        """Give the protocol at a variable's first and last value."""
        return tuple(
            changed(self._tree, self._composed({key: value})) for value in self._swept[key].ends
        )

    def _one(self, key: str, value: Any) -> tuple[Change, ...]:
        places = self._places[key]
        if places is not None:
            return tuple(Change(path=path, value=value) for path in places)
        return self._composed({key: value})

    def _composed(self, values: Mapping[str, Any]) -> tuple[Change, ...]:
        known = json.dumps(dict(values), sort_keys=True)
        if known not in self._known:
            tree = canonical_tree(freeze(self._composer.protocol(values)))
            self._known[known] = tuple(differences(self._tree, tree))
        return self._known[known]

    def _direct(self, one: Swept) -> Paths | None:
        """Give the places at which a variable's values stand, None when they do more than that."""
        found = []
        for value in one.ends:
            changes = self._composed({one.variable.key: value})
            if any(change.value != value for change in changes):
                return None
            found.append(tuple(change.path for change in changes))
        longest = max(found, key=len)
        # A value that is the base's own changes nothing, and a list of words may be pages.
        alike = all(paths in ((), longest) for paths in found)
        numbers = isinstance(one.values, Interval) or all(
            isinstance(value, int | float) for value in one.values
        )
        return longest if alike and numbers and longest else None

    def _are_separable(self) -> bool:
        """Tell whether no variable changes a place at or below which another one works."""
        touched: dict[str, Paths] = {}
        for key, one in self._swept.items():
            values = one.ends if isinstance(one.values, Interval) else one.values
            touched[key] = self._places[key] or tuple(
                {change.path for value in values for change in self._composed({key: value})}
            )
        keys = list(touched)
        return not any(
            _overlap(first, second)
            for place, key in enumerate(keys)
            for other in keys[place + 1 :]
            for first in touched[key]
            for second in touched[other]
        )


def canonical_tree(frozen: FrozenProtocol) -> dict[str, Any]:
    """Give the canonical text as a tree."""
    tree: dict[str, Any] = json.loads(frozen.canonical_json)
    return tree


def changed(tree: Mapping[str, Any], changes: Sequence[Change]) -> Protocol:
    """Give the protocol of a canonical tree with some places changed; raises ValidationError."""
    full = deepcopy(dict(tree))
    for change in changes:
        *parents, last = change.path
        inside: Any = full
        for parent in parents:
            inside = inside[parent]
        inside[last] = change.value
    return thaw(json.dumps(full))


def differences(old: Any, new: Any, path: tuple[str | int, ...] = ()) -> Iterator[Change]:
    """List the smallest places in which two canonical trees of one shape differ."""
    if old == new:
        return
    if isinstance(old, dict) and isinstance(new, dict) and old.keys() == new.keys():
        for key in old:
            yield from differences(old[key], new[key], (*path, key))
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for place, (one, other) in enumerate(zip(old, new, strict=True)):
            yield from differences(one, other, (*path, place))
    else:
        yield Change(path=path, value=new)


def _overlap(one: tuple[str | int, ...], other: tuple[str | int, ...]) -> bool:
    shorter = min(len(one), len(other))
    return one[:shorter] == other[:shorter]
