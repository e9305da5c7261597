"""The Python modules of the serial protocol."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from textwrap import wrap

from description import MARK, Field, Message, Protocol, bounds, sentence

PACKED = {"i8": "b", "u8": "B", "i16": "h", "u16": "H", "u32": "I"}
MATRIX = 9
WIDTH = 88
"""Characters of a docstring's line."""


def _class(name: str) -> str:
    return "".join(word.capitalize() for word in name.split("_"))


def messages(protocol: Protocol) -> str:
    """Give the module of the messages themselves."""
    raw = protocol.raw
    lines = [
        '"""The messages of the joystick\'s serial protocol, in wire steps.',
        "",
        f"{MARK}.",
        '"""',
        "",
        "from __future__ import annotations",
        "",
        "from enum import IntEnum, IntFlag",
        "from typing import NamedTuple",
        "",
        "Three = tuple[int, int, int]",
        "Nine = tuple[int, int, int, int, int, int, int, int, int]",
        "",
        f"PROTOCOL_VERSION = {raw['version']}",
        f"BAUD = {raw['baud']}",
        f"TICK_HZ = {raw['tick_hz']}",
        f"LONGEST_PAYLOAD = {raw['longest_payload']}",
    ]
    for key, (value, meaning) in raw["constants"].items():
        lines += [f"{key} = {value}", f'"""{sentence(meaning)}"""']
    for base, group in (("IntEnum", "enums"), ("IntFlag", "flags")):
        for name, told in raw[group].items():
            lines += ["", "", f"class {name}({base}):", f'    """{sentence(told["meaning"])}"""']
            for key, (value, meaning) in told["members"].items():
                shown = value if group == "enums" else f"{value:#x}"
                lines += [f"    {key} = {shown}", *_docstring(meaning)]
    own = [message for message in protocol.messages if message.like is None]
    for message in own:
        lines += ["", "", *_named_tuple(message)]
    for message in protocol.messages:
        if message.like is not None:
            base = _class(message.like)
            lines += [
                "",
                "",
                f"class {_class(message.name)}({base}):",
                *_docstring(message.meaning),
            ]
            lines += ["", "    __slots__ = ()"]
    return _laid_out(lines)


def layouts(protocol: Protocol) -> str:
    """Give the module of how the messages travel."""
    names = ", ".join(sorted(_names(protocol)))
    lines = [
        '"""How the messages of the serial protocol are packed, scaled and limited.',
        "",
        f"{MARK}.",
        '"""',
        "",
        "from __future__ import annotations",
        "",
        "from struct import Struct",
        "",
        f"from omnistudy.devices.stick.messages import {names}",
    ]
    lines += ["", "", "Message = (", "    " + "\n    | ".join(_names(protocol)), ")"]
    lines += ["", "KINDS: dict[int, type[Message]] = {"]
    lines += [f"    {one.code:#04x}: {_class(one.name)}," for one in protocol.messages]
    lines += ["}", '"""Code on the wire -> message."""', ""]
    lines += ["CODES = {kind: code for code, kind in KINDS.items()}"]
    lines += ['"""Message -> code on the wire."""', "", "LAYOUTS: dict[type[Message], Struct] = {"]
    lines += [f'    {_class(one.name)}: Struct("<{_packed(one)}"),' for one in protocol.messages]
    lines += ["}", '"""How a message\'s payload is packed."""', ""]
    lines += ["COUNTS: dict[type[Message], tuple[int, ...]] = {"]
    lines += [
        f"    {_class(m.name)}: {tuple(f.count for f in m.fields)}," for m in protocol.messages
    ]
    lines += ["}", '"""How many numbers each field of a message has."""', ""]
    lines += [*_scales(protocol), "", *_limits(protocol), "", *_default(protocol)]
    return _laid_out(lines)


def _names(protocol: Protocol) -> list[str]:
    return [_class(message.name) for message in protocol.messages]


def _packed(message: Message) -> str:
    return "".join(
        (str(field.count) if field.count > 1 else "") + PACKED[field.type]
        for field in message.fields
    )


def _named_tuple(message: Message) -> list[str]:
    lines = [f"class {_class(message.name)}(NamedTuple):", *_docstring(message.meaning)]
    lines += [""] if message.fields else []
    for field in message.fields:
        kind = "Nine" if field.count == MATRIX else "Three" if field.count > 1 else "int"
        told = f"{sentence(field.meaning).rstrip('.')}{_unit(field)}."
        lines += [f"    {field.name}: {kind}", *_docstring(told)]
    return lines


def _unit(field: Field) -> str:
    if field.scale > 1:
        return f"; {field.scale} steps a {field.unit}"
    return "" if field.unit == "1" else f"; {field.unit}"


def _docstring(meaning: str) -> list[str]:
    text = sentence(meaning)
    if len(text) <= WIDTH:
        return [f'    """{text}"""']
    head, rest = text.split(". ", 1) if ". " in text else text.split(", ", 1)
    end = "." if ". " in text else ","
    body = [f"    {line}" for line in wrap(rest, WIDTH)]
    return [f'    """{head}{end}', "", *body, '    """']


def _scales(protocol: Protocol) -> list[str]:
    lines = ["SCALES = {"]
    for message in protocol.messages:
        scaled = {f.name: f.scale for f in message.fields if f.scale > 1}
        if scaled and message.like is None:
            lines.append(f"    {_class(message.name)}: {_literal(scaled)},")
    meaning = "Message -> field -> wire steps a unit; fields that are not named have one."
    return [*lines, "}", f'"""{meaning}"""']


def _limits(protocol: Protocol) -> list[str]:
    lines = ["LIMITS = {"]
    for message in protocol.messages:
        limited = {f.name: bounds(f) for f in message.fields if (f.low, f.high) != (None, None)}
        if limited and message.like is None:
            lines.append(f"    {_class(message.name)}: {_literal(limited)},")
    meaning = "Message -> field -> least and greatest wire step that the device takes."
    return [*lines, "}", f'"""{meaning}"""']


def _literal(mapping: Mapping[str, object]) -> str:
    return "{" + ", ".join(f'"{key}": {value}' for key, value in mapping.items()) + "}"


def _default(protocol: Protocol) -> list[str]:
    (message,) = (one for one in protocol.messages if one.name == "configuration")
    lines = ["DEFAULT_CONFIGURATION = Configuration("]
    for field in message.fields:
        value = tuple(field.default) if isinstance(field.default, list) else field.default
        lines.append(f"    {field.name}={value},")
    return [*lines, ")", '"""What a new device uses."""']


def _laid_out(lines: list[str]) -> str:
    source = "\n".join(lines) + "\n"
    for rules in (("check", "--fix", "--quiet", "--select", "I"), ("format",)):
        ruff = [sys.executable, "-m", "ruff", *rules, "--stdin-filename", "omnistudy/made.py", "-"]
        ran = subprocess.run(ruff, input=source, capture_output=True, text=True, check=True)
        source = ran.stdout
    return source
