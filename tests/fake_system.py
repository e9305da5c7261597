"""A system with a fake device in it, and devices that are opened inside that system.

umockdev shows a process what is plugged in by LD_PRELOAD, which must be there when the process
begins: so the device lives in a process of its own.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing import get_context
from multiprocessing.managers import BaseManager
from pathlib import Path
from typing import Any
from unittest.mock import patch

from omnistudy.devices import RunningDevice
from omnistudy.devices.handheld.choice import Attached
from omnistudy.devices.handheld.handheld import Handheld

SYSTEM_PYTHON = "/usr/bin/python3"
"""The one that has python3-gi."""
PRELOADED = "libumockdev-preload.so.0"


def missing() -> str:
    """Say what a fake system needs and has not; "" when nothing is missing."""
    asked = "import gi; gi.require_version('UMockdev', '1.0'); from gi.repository import UMockdev"
    try:
        subprocess.run([SYSTEM_PYTHON, "-c", asked], check=True, capture_output=True)
        subprocess.run(["umockdev-wrapper", "true"], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        return "umockdev, gir1.2-umockdev-1.0 and python3-gi: `make system-packages`"
    return ""


class FakeSystem:
    """A device of umockdev's (a script beside this file), told what to do by lines."""

    def __init__(self, script: str, *arguments: str) -> None:
        path = Path(__file__).with_name(script)
        self._server = subprocess.Popen(
            ["umockdev-wrapper", SYSTEM_PYTHON, str(path), *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self._server.stdout is not None
        self.environment = {
            "UMOCKDEV_DIR": self._server.stdout.readline().strip(),
            "LD_PRELOAD": PRELOADED,
        }

    def say(self, order: str) -> Any:
        """Give an order, and what the device answered."""
        assert self._server.stdin is not None
        assert self._server.stdout is not None
        self._server.stdin.write(order + "\n")
        self._server.stdin.flush()
        return json.loads(self._server.stdout.readline())

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Let processes that begin meanwhile see the fake device."""
        with patch.dict(os.environ, self.environment):
            yield

    def close(self) -> None:
        """End it."""
        self._server.communicate()


class Opened:
    """A running device in the other process, its attributes asked for by methods."""

    def __init__(self, device: Handheld, physics_hz: int) -> None:
        self._running: RunningDevice = device.connect(physics_hz)

    def ask(self, name: str, *arguments: Any) -> Any:
        """Give an attribute, or what a method gives."""
        found = getattr(self._running, name)
        return found(*arguments) if callable(found) else found


def attached(module: str, function: str) -> tuple[Attached, ...]:
    """List what is plugged in there."""
    from importlib import import_module

    found: tuple[Attached, ...] = getattr(import_module(module), function)()
    return found


class Process(BaseManager):
    """The process in which devices are opened."""


Process.register("Opened", Opened)
Process.register("attached", attached)


@contextmanager
def process_inside(system: FakeSystem) -> Iterator[Any]:
    """Give a process that sees the fake device."""
    with system.inside(), _process() as process:
        yield process


@contextmanager
def preloaded_process() -> Iterator[Any]:
    """Give a process that sees a fake device once it has made one itself."""
    with patch.dict(os.environ, {"LD_PRELOAD": PRELOADED}), _process() as process:
        yield process


@contextmanager
def _process() -> Iterator[Any]:
    process = Process(ctx=get_context("spawn"))
    process.start()
    try:
        yield process
    finally:
        process.shutdown()
