"""The page of the serial protocol, for people."""

from __future__ import annotations

from description import MARK, Message, Protocol, bounds


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
        "What bounds the force, and what each fault does: [safety](safety.md).",
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
        low, high = bounds(field)
        limits = f"{low} .. {high}" if (field.low, field.high) != (None, None) else ""
        default = field.default if field.default is not None else ""
        shown = ", ".join(map(str, default)) if isinstance(default, list) else default
        cells = (size, field.unit, field.scale, limits, shown, field.meaning)
        lines.append(" | ".join((f"| `{field.name}`", *map(str, cells))) + " |")
    return lines
