"""The published protocol's page, composed once, and what somebody might write into it."""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from functools import cache
from typing import Any

import yaml

from omnistudy.protocol import Protocol
from omnistudy.protocol.completion import completed
from omnistudy.protocol.compose import find_protocol, page_reader, read_protocol
from omnistudy.protocol.page import composed
from omnistudy.registry.conf import conf_roots


@cache
def sound_page() -> dict[str, Any]:
    page = find_protocol("utah2017_component")
    return composed(page.stem, (page.parent, *conf_roots()), (), ())


def changed_page(changes: Sequence[str]) -> dict[str, Any]:
    """Give the page with `key=value` set and `~key` taken out."""
    tree = deepcopy(sound_page())
    for change in changes:
        path, _, text = change.removeprefix("~").partition("=")
        *parents, last = path.split(".")
        inside = tree
        for parent in parents:
            inside = inside.setdefault(parent, {})
        if change.startswith("~"):
            del inside[last]
        else:
            inside[last] = yaml.safe_load(text)
    return tree


def changed_protocol(*changes: str) -> Protocol:
    """Read the changed page; raises ProtocolFaults."""
    page = page_reader("page.yaml", conf_roots())
    return read_protocol(completed(changed_page(changes), page), "page.yaml")
