"""A line that carries bytes to and from a stick: a serial port, or the emulated board."""

from __future__ import annotations

from typing import Protocol


class Transport(Protocol):
    """A two-way line of bytes with a clock of its own."""

    def write(self, data: bytes) -> None:
        """Send bytes to the device."""

    def read(self, seconds: float) -> bytes:
        """Let `seconds` of the line's time pass, or less if bytes came; give what came."""

    def now(self) -> float:
        """Give the line's time, s: wall time of a serial port, emulated time of the emulator."""

    def close(self) -> None:
        """End the line; the device notices the silence and goes soft."""
