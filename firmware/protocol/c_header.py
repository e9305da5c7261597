"""The C header of the serial protocol."""

from __future__ import annotations

from description import MARK, Field, Message, Protocol

C_TYPES = {"i8": "int8_t", "u8": "uint8_t", "i16": "int16_t", "u16": "uint16_t", "u32": "uint32_t"}


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
