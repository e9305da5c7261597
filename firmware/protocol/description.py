"""The description of the serial protocol as values."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import yaml

DESCRIPTION = Path(__file__).resolve().parent / "description.yaml"
MARK = "Written by firmware/protocol/make.py from firmware/protocol/description.yaml"
BYTES = {"i8": 1, "u8": 1, "i16": 2, "u16": 2, "u32": 4}


class Field(NamedTuple):
    """One field of a message, as description.yaml orders its items."""

    name: str
    type: str
    count: int
    scale: int
    low: int | None
    high: int | None
    default: int | list[int] | None
    unit: str
    meaning: str

    @property
    def bytes(self) -> int:
        """Bytes on the wire."""
        return BYTES[self.type] * self.count


class Message(NamedTuple):
    """One message; `fields` may be another's."""

    name: str
    code: int
    sender: str
    meaning: str
    fields: tuple[Field, ...]
    like: str | None

    @property
    def bytes(self) -> int:
        """Bytes of payload."""
        return sum(field.bytes for field in self.fields)


class Protocol(NamedTuple):
    """The description as values."""

    raw: Mapping[str, Any]
    messages: tuple[Message, ...]


def read_description() -> Protocol:
    """Read description.yaml."""
    raw = yaml.safe_load(DESCRIPTION.read_text(encoding="utf-8"))
    named = raw["messages"]
    messages = []
    for name, told in named.items():
        source = named[told["like"]] if "like" in told else told
        fields = tuple(Field(key, *items) for key, items in source.get("fields", {}).items())
        messages.append(
            Message(name, told["code"], told["sender"], told["meaning"], fields, told.get("like"))
        )
    assert max(message.bytes for message in messages) <= raw["longest_payload"]
    return Protocol(raw, tuple(messages))


def sentence(meaning: str) -> str:
    """Give a text as one sentence, with a capital and a full stop."""
    text = " ".join(meaning.split())
    return text[0].upper() + text[1:] + ("" if text.endswith(".") else ".")


def bounds(field: Field) -> tuple[int, int]:
    """Give the least and the greatest wire step of a field."""
    bits = 8 * BYTES[field.type]
    least = -(2 ** (bits - 1)) if field.type.startswith("i") else 0
    low = least if field.low is None else field.low
    return low, (least + 2**bits - 1 if field.high is None else field.high)
