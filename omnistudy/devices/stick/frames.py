"""Frames of the serial protocol: COBS( code, sequence, payload, CRC ), 0."""

from __future__ import annotations

from binascii import crc_hqx
from typing import Any, NamedTuple

from omnistudy.devices.stick.layouts import CODES, COUNTS, KINDS, LAYOUTS, Message
from omnistudy.devices.stick.messages import LONGEST_PAYLOAD

CRC_START = 0xFFFF
LONGEST_FRAME = LONGEST_PAYLOAD + 4 + 1
"""Bytes between two zeros: code, sequence, CRC and one byte of COBS."""


class Received(NamedTuple):
    """A message with its sequence number."""

    message: Message
    sequence: int


def stuff(content: bytes) -> bytes:
    """Encode by COBS: no zero is left (Cheshire and Baker 1999); at most 253 bytes."""
    return b"".join(bytes((len(run) + 1,)) + run for run in content.split(b"\0"))


def unstuff(encoded: bytes) -> bytes | None:
    """Decode COBS of at most 253 bytes; None when it is none."""
    runs = []
    at = 0
    while at < len(encoded):
        length = encoded[at]
        run = encoded[at + 1 : at + length]
        if length == 0 or len(run) != length - 1:
            return None
        runs.append(run)
        at += length
    return b"\0".join(runs)


def encode(message: Message, sequence: int) -> bytes:
    """Give a whole frame, its zero byte included; `sequence` counts modulo 256."""
    kind = type(message)
    head = bytes((CODES[kind], sequence & 0xFF))
    return frame_of(head + LAYOUTS[kind].pack(*_flat(message)))


def frame_of(content: bytes) -> bytes:
    """Give the frame of code, sequence and payload, whatever they are."""
    return stuff(content + crc_hqx(content, CRC_START).to_bytes(2, "big")) + b"\0"


def decode(encoded: bytes) -> Received | None:
    """Give the message between two zero bytes; None when it is damaged or unknown."""
    content = unstuff(encoded)
    if content is None or len(content) < 4 or crc_hqx(content, CRC_START) != 0:
        return None
    kind = KINDS.get(content[0])
    if kind is None or LAYOUTS[kind].size != len(content) - 4:
        return None
    return Received(_message(kind, LAYOUTS[kind].unpack(content[2:-2])), content[1])


def _flat(message: Message) -> list[int]:
    flat: list[int] = []
    for value in message:
        if isinstance(value, tuple):
            flat.extend(value)
        else:
            flat.append(value)
    return flat


def _message(kind: type[Message], values: tuple[int, ...]) -> Message:
    fields: list[Any] = []
    at = 0
    for count in COUNTS[kind]:
        fields.append(values[at] if count == 1 else values[at : at + count])
        at += count
    return kind(*fields)


class Deframer:
    """Cuts a stream of bytes into messages; what is damaged is dropped and counted."""

    def __init__(self) -> None:
        self.damaged = 0
        self._begun = False
        self._rest = b""

    def feed(self, chunk: bytes) -> list[Received]:
        """Give the messages that end within `chunk`.

        What stands before the first zero byte is no frame: the line may have been joined midway.
        """
        *frames, self._rest = (self._rest + chunk).split(b"\0")
        self._rest = self._rest[-LONGEST_FRAME - 1 :]
        if frames and not self._begun:
            self._begun = True
            frames = frames[1:]
        received = []
        for frame in frames:
            if not frame:
                continue
            found = decode(frame)
            if found is None:
                self.damaged += 1
            else:
                received.append(found)
        return received
