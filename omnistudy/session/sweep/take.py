"""A row of a sweep as a protocol's page of its own: what was chosen, and where it comes from."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml
from hydra.core.override_parser.overrides_parser import OverridesParser

from omnistudy.errors import OmnistudyError
from omnistudy.errors.sweep import (
    ForeignFolder,
    PageExists,
    PageNotWritten,
    ProtocolMoved,
)
from omnistudy.protocol import freeze
from omnistudy.protocol.compose import GROUPS, compose_protocol, find_protocol
from omnistudy.session.sweep.effects import Composer, canonical_tree, differences
from omnistudy.session.sweep.question import Change, Sweep


def take(
    sweep: Sweep,
    values: Mapping[str, Any],
    provenance: Sequence[str],
    page: Path,
    *,
    replace: bool = False,
) -> None:
    """Write a page that rests on the sweep's protocol and says the chosen values.

    provenance : lines of comment. The page is composed again before it stays.

    Raises PageExists, ForeignFolder, PageNotWritten, ProtocolMoved, ProtocolFaults.
    """
    base = find_protocol(sweep.protocol)
    _check_place(sweep, base, page, replace)
    composer = Composer(sweep.protocol, sweep.overrides)
    moved = differences(sweep.base, canonical_tree(freeze(composer.protocol({}))))
    if paths := _named(moved):
        raise ProtocolMoved(sweep.protocol, paths)
    before = page.read_bytes() if page.exists() else None
    try:
        page.write_text(_text(sweep, base, values, provenance, page), encoding="utf-8")
    except OSError as refused:
        raise PageNotWritten(page, refused.strerror or str(refused)) from refused
    try:
        _check_page(composer, values, page)
    except OmnistudyError:
        if before is None:
            page.unlink()
        else:
            page.write_bytes(before)
        raise


def _check_place(sweep: Sweep, base: Path, page: Path, replace: bool) -> None:
    if page.suffix != ".yaml":
        raise PageNotWritten(page, "a protocol's page is called NAME.yaml")
    if page.stem == base.stem:
        raise PageNotWritten(page, f"it would rest on itself; call it other than {base.name}")
    if page.exists() and not replace:
        raise PageExists(page)
    given_as_file = Path(sweep.protocol).suffix == ".yaml"
    if given_as_file and page.resolve().parent != base.parent:
        raise ForeignFolder(page, base.parent)


def _check_page(composer: Composer, values: Mapping[str, Any], page: Path) -> None:
    """Compose what was written and hold it against what was driven; raises PageNotWritten."""
    wanted = canonical_tree(freeze(composer.protocol(values)))
    written = canonical_tree(freeze(compose_protocol(page)))
    differing = [path for path in _named(differences(wanted, written)) if path != "name"]
    if differing:
        raise PageNotWritten(page, f"it would not say what was driven ({', '.join(differing)})")


def _named(changes: Any) -> list[str]:
    found: list[Change] = list(changes)
    return [".".join(str(step) for step in change.path) for change in found]


def _text(
    sweep: Sweep, base: Path, values: Mapping[str, Any], provenance: Sequence[str], page: Path
) -> str:
    settings: dict[str, Any] = {}
    chosen: list[dict[str, str]] = []
    for key, value in [*_fixed(sweep, page), *values.items()]:
        if key in GROUPS and isinstance(value, str):
            chosen.append({f"override {key}": value})
        else:
            _put(settings, key.split("."), value)
    name = page.stem if re.fullmatch(r"[a-z][a-z0-9_]*", page.stem) else f"{base.stem}_taken"
    content = {"defaults": [base.stem, *chosen, "_self_"], "name": name, **settings}
    comment = "".join(f"# {line}\n" if line else "#\n" for line in provenance)
    return comment + "\n" + yaml.safe_dump(content, sort_keys=False, allow_unicode=True)


def _fixed(sweep: Sweep, page: Path) -> list[tuple[str, Any]]:
    """Read the overrides that hold for every point."""
    found = []
    for override in OverridesParser.create().parse_overrides(list(sweep.overrides)):
        if override.is_delete():
            raise PageNotWritten(page, f"a page cannot say '{override.input_line}'")
        found.append((override.key_or_group, override.value()))
    return found


def _put(settings: dict[str, Any], steps: list[str], value: Any) -> None:
    *parents, last = steps
    inside = settings
    for parent in parents:
        inside = inside.setdefault(parent, {})
    inside[last] = value
