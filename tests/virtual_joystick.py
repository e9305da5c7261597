"""A joystick that SDL takes for a real one, and a child process to use SDL in."""

from __future__ import annotations

import os
import traceback
from collections.abc import Callable
from ctypes import byref
from functools import wraps
from multiprocessing import get_context
from multiprocessing.connection import Connection

import pytest


def in_a_child(test: Callable[..., None]) -> Callable[..., None]:
    """Run a test in a process of its own, which SDL may do with what it likes."""

    @wraps(test)
    def run(**arguments: object) -> None:
        context = get_context("fork")
        hearing, telling = context.Pipe(duplex=False)
        child = context.Process(target=_tell, args=(test, arguments, telling))
        child.start()
        telling.close()
        said = hearing.recv() if hearing.poll(60) else "the child said nothing for 60 s"
        child.join()
        hearing.close()
        if said:
            pytest.fail(said, pytrace=False)

    return run


def _tell(test: Callable[..., None], arguments: dict[str, object], telling: Connection) -> None:
    os.environ["SDL_VIDEODRIVER"] = "dummy"
    try:
        test(**arguments)
    except BaseException:
        telling.send(traceback.format_exc())
    else:
        telling.send("")
    os._exit(0)


class VirtualJoystick:
    """Six axes, twelve buttons and a hat; plugged in until `unplug`."""

    def __init__(self, name: str = "Virtual Stick", gamepad: bool = False) -> None:
        import sdl2

        self._sdl = sdl2
        sdl2.SDL_SetHint(sdl2.SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, b"1")
        assert sdl2.SDL_InitSubSystem(sdl2.SDL_INIT_JOYSTICK | sdl2.SDL_INIT_GAMECONTROLLER) == 0
        self._name = name.encode()
        described = sdl2.SDL_VirtualJoystickDesc()
        described.version = sdl2.SDL_VIRTUAL_JOYSTICK_DESC_VERSION
        described.type = (
            sdl2.SDL_JOYSTICK_TYPE_GAMECONTROLLER
            if gamepad
            else sdl2.SDL_JOYSTICK_TYPE_FLIGHT_STICK
        )
        described.naxes, described.nbuttons, described.nhats = 6, 12, 1
        described.vendor_id, described.product_id = 0x1234, 0x5678
        described.name = self._name
        self._index = sdl2.SDL_JoystickAttachVirtualEx(byref(described))
        assert self._index >= 0, sdl2.SDL_GetError()
        self._joystick = sdl2.SDL_JoystickOpen(self._index)
        assert self._joystick, sdl2.SDL_GetError()

    def move(self, axis: int, value: int) -> None:
        """Put an axis to -32768 ... 32767."""
        assert self._sdl.SDL_JoystickSetVirtualAxis(self._joystick, axis, value) == 0

    def press(self, button: int, down: bool = True) -> None:
        """Press or release a button."""
        assert self._sdl.SDL_JoystickSetVirtualButton(self._joystick, button, int(down)) == 0

    def point(self, up: bool) -> None:
        """Point the hat up, or let it go."""
        hat = self._sdl.SDL_HAT_UP if up else self._sdl.SDL_HAT_CENTERED
        assert self._sdl.SDL_JoystickSetVirtualHat(self._joystick, 0, hat) == 0

    def unplug(self) -> None:
        """Take it away."""
        assert self._sdl.SDL_JoystickDetachVirtual(self._index) == 0
