"""Write the C header, the Python module and the page of the serial protocol from protocol.yaml."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple

import yaml

HERE = Path(__file__).resolve().parent
DESCRIPTION = HERE / "protocol.yaml"
HEADER = HERE / "src" / "protocol.h"
MODULE = HERE.parent / "omnistudy" / "devices" / "stick" / "messages.py"
PAGE = HERE.parent / "docs" / "joystick-protocol.md"
MARK = "Written by firmware/make_protocol.py from firmware/protocol.yaml"

C_TYPES = {"i8": "int8_t", "u8": "uint8_t", "i16": "int16_t", "u16": "uint16_t", "u32": "uint32_t"}
PACKED = {"i8": "b", "u8": "B", "i16": "h", "u16": "H", "u32": "I"}
BYTES = {"i8": 1, "u8": 1, "i16": 2, "u16": 2, "u32": 4}
MATRIX = 9
WIDTH = 88
"""Characters of a docstring's line."""


class Field(NamedTuple):
    """One field of a message, as protocol.yaml orders its items."""

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
    """Read protocol.yaml."""
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


def _class(name: str) -> str:
    return "".join(word.capitalize() for word in name.split("_"))


def header(protocol: Protocol) -> str:
    """Give the C header."""
    raw = protocol.raw
    lines = [
        f"/* {MARK}. */",
        "#ifndef PROTOCOL_H",
        "#define PROTOCOL_H",
        "",
        "#include <stdbool.h>",
        "#include <stdint.h>",
        "",
        f"#define PROTOCOL_VERSION {raw['version']}",
        f"#define BAUD {raw['baud']}UL",
        f"#define TICK_HZ {raw['tick_hz']}",
        f"#define LONGEST_PAYLOAD {raw['longest_payload']}",
    ]
    lines += [f"#define {key} {value:#x}UL" for key, (value, _) in raw["constants"].items()]
    for name, told in (raw["enums"] | raw["flags"]).items():
        members = told["members"].items()
        lines += ["", "enum {"]
        lines += [f"    {name.upper()}_{key} = {value:#x}," for key, (value, _) in members]
        lines += ["};"]
    lines += ["", "enum {"]
    lines += [f"    MESSAGE_{one.name.upper()} = {one.code:#04x}," for one in protocol.messages]
    lines += ["};"]
    for message in protocol.messages:
        if message.fields and message.like is None:
            lines += ["", *_struct(message)]
    lines += ["", "#endif"]
    return "\n".join(lines) + "\n"


def _struct(message: Message) -> list[str]:
    name = message.name
    lines = [f"struct {name} {{"]
    for field in message.fields:
        size = f"[{field.count}]" if field.count > 1 else ""
        lines.append(f"    {C_TYPES[field.type]} {field.name}{size};")
    lines += ["} __attribute__((packed));"]
    lines += [f'_Static_assert(sizeof(struct {name}) == {message.bytes}, "{name} is packed");']
    bounded = [one for one in message.fields if (one.low, one.high) != (None, None)]
    if bounded:
        lines += ["", f"static inline bool {name}_is_legal(const struct {name} *{name})", "{"]
        for field in bounded:
            lines += _check(name, field)
        lines += ["    return true;", "}"]
    if any(field.default is not None for field in message.fields):
        values = ", ".join(_initial(field.default) for field in message.fields)
        lines += ["", f"#define DEFAULT_{name.upper()} {{ {values} }}"]
    return lines


def _initial(default: int | list[int] | None) -> str:
    if isinstance(default, list):
        return "{ " + ", ".join(str(value) for value in default) + " }"
    return str(default)


def _check(name: str, field: Field) -> list[str]:
    value = f"{name}->{field.name}" + ("[i]" if field.count > 1 else "")
    bounds = [f"{value} < {field.low}"] if field.low is not None else []
    bounds += [f"{value} > {field.high}"] if field.high is not None else []
    test = f"if ({' || '.join(bounds)})"
    if field.count == 1:
        return [f"    {test}", "        return false;"]
    loop = f"    for (uint8_t i = 0; i < {field.count}; i++)"
    return [loop, f"        {test}", "            return false;"]


def module(protocol: Protocol) -> str:
    """Give the Python module."""
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
        "from struct import Struct",
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
        lines += [f"{key} = {value}", f'"""{_sentence(meaning)}"""']
    for base, group in (("IntEnum", "enums"), ("IntFlag", "flags")):
        for name, told in raw[group].items():
            lines += ["", "", f"class {name}({base}):", f'    """{_sentence(told["meaning"])}"""']
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
    return "\n".join(lines) + "\n"


def _names(protocol: Protocol) -> list[str]:
    return [_class(message.name) for message in protocol.messages]


def _packed(message: Message) -> str:
    return "".join(
        (str(field.count) if field.count > 1 else "") + PACKED[field.type]
        for field in message.fields
    )


def _sentence(meaning: str) -> str:
    text = " ".join(meaning.split())
    return text[0].upper() + text[1:] + ("" if text.endswith(".") else ".")


def _named_tuple(message: Message) -> list[str]:
    lines = [f"class {_class(message.name)}(NamedTuple):", *_docstring(message.meaning)]
    lines += [""] if message.fields else []
    for field in message.fields:
        kind = "Nine" if field.count == MATRIX else "Three" if field.count > 1 else "int"
        told = f"{_sentence(field.meaning).rstrip('.')}{_unit(field)}."
        lines += [f"    {field.name}: {kind}", *_docstring(told)]
    return lines


def _unit(field: Field) -> str:
    if field.scale > 1:
        return f"; {field.scale} steps a {field.unit}"
    return "" if field.unit == "1" else f"; {field.unit}"


def _docstring(meaning: str) -> list[str]:
    text = _sentence(meaning)
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
        bounds = {f.name: _bounds(f) for f in message.fields if (f.low, f.high) != (None, None)}
        if bounds and message.like is None:
            lines.append(f"    {_class(message.name)}: {_literal(bounds)},")
    meaning = "Message -> field -> least and greatest wire step that the device takes."
    return [*lines, "}", f'"""{meaning}"""']


def _literal(mapping: Mapping[str, object]) -> str:
    return "{" + ", ".join(f'"{key}": {value}' for key, value in mapping.items()) + "}"


def _bounds(field: Field) -> tuple[int, int]:
    bits = 8 * BYTES[field.type]
    least = -(2 ** (bits - 1)) if field.type.startswith("i") else 0
    low = least if field.low is None else field.low
    return low, (least + 2**bits - 1 if field.high is None else field.high)


def _default(protocol: Protocol) -> list[str]:
    (message,) = (one for one in protocol.messages if one.name == "configuration")
    lines = ["DEFAULT_CONFIGURATION = Configuration("]
    for field in message.fields:
        value = tuple(field.default) if isinstance(field.default, list) else field.default
        lines.append(f"    {field.name}={value},")
    return [*lines, ")", '"""What a new device uses."""']


def page(protocol: Protocol) -> str:
    """Give the page for people."""
    raw = protocol.raw
    lines = [
        "# The joystick's serial protocol",
        "",
        f"{MARK}; a test tells when it is stale.",
        "",
        f"Version {raw['version']}. {_line(raw['line'])}",
        "",
        "## A frame",
        "",
        "    COBS( code, sequence, payload, CRC high, CRC low ), 0x00",
        "",
        _line(raw["frame"]),
        "",
        _line(raw["refusal"]),
        "",
        "## Constants",
        "",
        "| name | value | meaning |",
        "| --- | --- | --- |",
    ]
    lines += [
        f"| `{k}` | {v if v < 2**20 else hex(v)} | {m} |" for k, (v, m) in raw["constants"].items()
    ]
    for name, told in (raw["enums"] | raw["flags"]).items():
        lines += [
            "",
            f"## {name}: {told['meaning']}",
            "",
            "| name | value | meaning |",
            "| --- | --- | --- |",
        ]
        hexed = name in raw["flags"]
        for key, (value, meaning) in told["members"].items():
            lines.append(f"| `{key}` | {f'{value:#06x}' if hexed else value} | {meaning} |")
    lines += ["", "## Messages"]
    for message in protocol.messages:
        lines += ["", *_section(message)]
    return "\n".join(lines) + "\n"


def _line(text: str) -> str:
    return " ".join(text.split())


def _section(message: Message) -> list[str]:
    told = f"({message.code:#04x}, from the {message.sender}, {message.bytes} bytes)"
    lines = [
        f"### `{message.name}` {told}",
        "",
        " ".join(message.meaning.split()),
    ]
    if message.like:
        return [*lines, "", f"Its fields are those of `{message.like}`."]
    if not message.fields:
        return lines
    lines += [
        "",
        "| field | type | unit | steps a unit | limits (steps) | default (steps) | meaning |",
    ]
    lines += ["| --- | --- | --- | --- | --- | --- | --- |"]
    for field in message.fields:
        size = f"{field.count} x {field.type}" if field.count > 1 else field.type
        low, high = _bounds(field)
        limits = f"{low} .. {high}" if (field.low, field.high) != (None, None) else ""
        default = field.default if field.default is not None else ""
        shown = ", ".join(map(str, default)) if isinstance(default, list) else default
        cells = (size, field.unit, field.scale, limits, shown, field.meaning)
        lines.append(" | ".join((f"| `{field.name}`", *map(str, cells))) + " |")
    return lines


def generated() -> dict[Path, str]:
    """Give every generated file with its text."""
    protocol = read_description()
    return {HEADER: header(protocol), MODULE: _laid_out(module(protocol)), PAGE: page(protocol)}


def _laid_out(source: str) -> str:
    command = [sys.executable, "-m", "ruff", "format", "--stdin-filename", str(MODULE), "-"]
    ran = subprocess.run(command, input=source, capture_output=True, text=True, check=True)
    return ran.stdout


if __name__ == "__main__":
    for path, text in generated().items():
        path.write_text(text, encoding="utf-8")
