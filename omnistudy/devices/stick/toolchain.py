"""Compiles the firmware and its emulator on the user's machine, once for each state of the sources.

The emulator stands on simavr, which is GPL: it is compiled from Debian's libsimavr-dev where it is
used, and never shipped.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

from omnistudy.errors.devices import NoFirmware, NoToolchain, ToolchainFailed

PACKAGE = Path(__file__).resolve().parents[2]
PACKED = PACKAGE / "_firmware"
SOURCES = PACKED if PACKED.is_dir() else PACKAGE.parent / "firmware"
"""The firmware's and the emulator's sources: in the wheel, else in the checkout."""
SIMAVR_HEADER = Path("/usr/include/simavr/sim_avr.h")
PROGRAMS = {"avr-gcc": "gcc-avr", "cc": "gcc", "make": "make"}
"""Program -> Debian package."""
FILES = {
    SIMAVR_HEADER: "libsimavr-dev",
    Path("/usr/include/libelf.h"): "libelf-dev",
    Path("/usr/lib/avr/include/avr/io.h"): "avr-libc",
}
"""Header -> Debian package."""


class Built(NamedTuple):
    """What the emulator is run from."""

    firmware: Path
    emulator: Path


def missing_packages() -> dict[str, str]:
    """Give what the emulator needs and is not here, with its Debian package."""
    programs = {name: package for name, package in PROGRAMS.items() if not shutil.which(name)}
    files = {str(path): package for path, package in FILES.items() if not path.is_file()}
    return programs | files


def build() -> Built:
    """Give the compiled firmware and emulator, compiling what is not in the cache yet.

    Raises NoFirmware, NoToolchain, ToolchainFailed.
    """
    if not (SOURCES / "Makefile").is_file():
        raise NoFirmware(SOURCES)
    folder = _cache() / _digest()
    built = Built(folder / "stick.elf", folder / "emulator.so")
    if built.firmware.is_file() and built.emulator.is_file():
        return built
    missing = missing_packages()
    if missing:
        raise NoToolchain(tuple(missing), tuple(dict.fromkeys(missing.values())))
    folder.parent.mkdir(parents=True, exist_ok=True)
    # Compiled aside and moved whole, so that two at once do not meet half a file.
    with tempfile.TemporaryDirectory(dir=folder.parent) as aside:
        _make(Path(aside))
        folder.mkdir(exist_ok=True)
        for path in built:
            (Path(aside) / path.name).replace(path)
    return built


def _make(folder: Path) -> None:
    command = ["make", "-C", str(SOURCES), f"OUT={folder}", "all"]
    ran = subprocess.run(command, capture_output=True, text=True)
    if ran.returncode != 0:
        raise ToolchainFailed(" ".join(command), " ".join(ran.stderr.split()))


def _cache() -> Path:
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "omnistudy" / "emulator"


def _digest() -> str:
    found = sha256()
    for path in sorted((SOURCES / "src").iterdir()) + sorted((SOURCES / "emulator").iterdir()):
        found.update(path.name.encode() + path.read_bytes())
    found.update((SOURCES / "Makefile").read_bytes())
    return found.hexdigest()[:16]
