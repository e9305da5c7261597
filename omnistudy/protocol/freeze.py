"""Freezing: a protocol as canonical text, and the two hashes that identify it."""

from __future__ import annotations

import hashlib
import json
from typing import Any, NamedTuple

from omnistudy.protocol.protocol import Protocol

SITE_KEYS = ("title", "description", "site", "messages", "device")
"""What the site hash covers, besides the conditions' masked labels; the design hash has the rest.

A condition that changes the device makes the device part of the design."""
STATED_ONLY = ("limits",)
"""Keys that are no part of the text where a protocol says nothing of them: protocols from before
there were such keys keep their hashes."""


class FrozenProtocol(NamedTuple):
    """A protocol as it is stored in a study.

    canonical_json : every number resolved, keys sorted, no spaces.
    design_hash, site_hash : 64 hex digits of SHA-256.
    """

    canonical_json: str
    design_hash: str
    site_hash: str


def freeze(protocol: Protocol) -> FrozenProtocol:
    """Give a protocol's canonical text and hashes.

    Mending a text changes the site hash alone and so redraws nothing.
    """
    dumped = protocol.model_dump(mode="json", serialize_as_any=True)
    tree = {key: value for key, value in dumped.items() if value or key not in STATED_ONLY}
    labels = [condition["masked_label"] for condition in tree["conditions"]]
    site = {key: tree[key] for key in SITE_KEYS} | {"masked_labels": labels}
    design = {key: value for key, value in tree.items() if key not in SITE_KEYS}
    design["conditions"] = [
        {key: value for key, value in condition.items() if key != "masked_label"}
        for condition in tree["conditions"]
    ]
    return FrozenProtocol(_canonical(tree), _digest(design), _digest(site))


def thaw(canonical_json: str) -> Protocol:
    """Give the protocol back from its canonical text."""
    return Protocol.model_validate(json.loads(canonical_json))


def _digest(tree: Any) -> str:
    return hashlib.sha256(_canonical(tree).encode()).hexdigest()


def _canonical(tree: Any) -> str:
    return json.dumps(
        _without_negative_zero(tree),
        sort_keys=True,
        separators=(",", ":"),
        ensure_ascii=False,
        allow_nan=False,
    )


def _without_negative_zero(tree: Any) -> Any:
    """-0.0 and 0.0 are the same number and must be the same text."""
    if isinstance(tree, dict):
        return {key: _without_negative_zero(value) for key, value in tree.items()}
    if isinstance(tree, list):
        return [_without_negative_zero(value) for value in tree]
    return 0.0 if isinstance(tree, float) and tree == 0.0 else tree
