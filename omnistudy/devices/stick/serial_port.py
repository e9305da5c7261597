"""The serial line of a real stick, or of the emulated one behind a pseudo-terminal. Linux."""

from __future__ import annotations

import fcntl
import os
import select
import termios
import time
from pathlib import Path

from omnistudy.devices.stick.messages import BAUD
from omnistudy.errors.devices import NoPort, PortLost, WhichPort

SPEED = termios.B500000
assert BAUD == 500_000
CHUNK = 4096
WRITE_WITHIN = 0.02
"""s; a field is on the line within two, and a port that takes nothing must stop nobody (ours)."""
PATTERNS = ("ttyACM*", "ttyUSB*")
"""Where Linux shows an Arduino Mega: an original under the first, most copies under the second."""


def attached_ports() -> tuple[str, ...]:
    """Name the serial ports of this machine at which a stick may be."""
    found = [path for pattern in PATTERNS for path in Path("/dev").glob(pattern)]
    return tuple(str(path) for path in sorted(found))


def only_port() -> str:
    """Give the one port at which a stick may be; raises WhichPort when there is none or several."""
    attached = attached_ports()
    if len(attached) != 1:
        raise WhichPort(attached)
    return attached[0]


class SerialPort:
    """A `Transport` in wall time; nobody else can open it meanwhile."""

    def __init__(self, path: str) -> None:
        """Open the port; raises NoPort. An Arduino resets when its port is opened."""
        self.path = path
        try:
            self._file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        except OSError as cause:
            raise NoPort(path, cause.strerror or str(cause), attached_ports()) from cause
        try:
            fcntl.ioctl(self._file, termios.TIOCEXCL)
            self._go_raw()
        except (termios.error, OSError) as cause:
            os.close(self._file)
            raise NoPort(path, "it is no serial port", attached_ports()) from cause

    def _go_raw(self) -> None:
        raw = termios.tcgetattr(self._file)
        raw[0] = raw[1] = raw[3] = 0
        raw[2] = termios.CS8 | termios.CREAD | termios.CLOCAL
        raw[4] = raw[5] = SPEED
        raw[6][termios.VMIN] = raw[6][termios.VTIME] = 0
        termios.tcsetattr(self._file, termios.TCSANOW, raw)

    def write(self, data: bytes) -> None:
        """Send bytes; raises PortLost, also when the port takes none for WRITE_WITHIN."""
        try:
            while data:
                _, writable, _ = select.select((), (self._file,), (), WRITE_WITHIN)
                if not writable:
                    raise PortLost(self.path)
                data = data[os.write(self._file, data) :]
        except OSError as cause:
            raise PortLost(self.path) from cause

    def read(self, seconds: float) -> bytes:
        """Wait at most `seconds` for bytes; raises PortLost when the stick was unplugged."""
        readable, _, _ = select.select((self._file,), (), (), seconds)
        if not readable:
            return b""
        try:
            chunk = os.read(self._file, CHUNK)
        except OSError as cause:
            raise PortLost(self.path) from cause
        if not chunk:
            raise PortLost(self.path)
        return chunk

    def now(self) -> float:
        """Give wall time, s."""
        return time.monotonic()

    def close(self) -> None:
        """Close the port; the stick notices the silence and goes soft."""
        os.close(self._file)
