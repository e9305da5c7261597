"""A gamepad or joystick as SDL2 tells it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from omnistudy.devices.device import Identity
from omnistudy.devices.handheld.axes import HardwareAxis
from omnistudy.devices.handheld.choice import Attached, the_one
from omnistudy.devices.handheld.hardware import Hardware
from omnistudy.devices.handheld.sdl_library import DEVICE, start_sdl, stop_sdl
from omnistudy.errors.handheld import CannotOpen

if TYPE_CHECKING:
    from omnistudy.devices.handheld.sdl_stick import SdlStick

LOW, HIGH = -32768.0, 32767.0
NO_GAMEPAD = "SDL does not know it as a gamepad: put 'read_as: joystick' and numbered axes"
GAMEPAD_AXES = ("left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger")
"""In SDL's order."""


class _Reader(NamedTuple):
    axis: HardwareAxis
    value: Callable[[], float]


def attached_sdl_sticks() -> tuple[Attached, ...]:
    """List what SDL finds; raises NoDriver, CannotOpen."""
    library = start_sdl()
    try:
        return _attached(library)
    finally:
        stop_sdl(library)


def _attached(library: Any) -> tuple[Attached, ...]:
    found = []
    for index in range(library.SDL_NumJoysticks()):
        joystick = library.SDL_JoystickOpen(index)
        if not joystick:
            continue  # unplugged between counting and opening
        name = (library.SDL_JoystickName(joystick) or b"joystick").decode()
        serial = (library.SDL_JoystickGetSerial(joystick) or b"").decode()
        library.SDL_JoystickClose(joystick)
        found.append(Attached(DEVICE, name, serial, str(index)))
    return tuple(found)


def open_sdl_stick(stick: SdlStick) -> SdlHardware:
    """Open the one that is meant; raises NoDriver, NothingPluggedIn, WhichDevice, CannotOpen."""
    library = start_sdl()
    try:
        chosen = the_one(DEVICE, _attached(library), stick.name, stick.serial)
        return SdlHardware(library, chosen, stick)
    except Exception:
        stop_sdl(library)
        raise


class SdlHardware(Hardware):
    """State as SDL has it when asked; nothing is queued."""

    def __init__(self, library: Any, attached: Attached, stick: SdlStick) -> None:
        self._sdl = library
        self._attached = attached
        index = int(attached.path)
        self._joystick = library.SDL_JoystickOpen(index)
        if not self._joystick:
            self._refuse(library.SDL_GetError().decode())
        self._controller = None
        if stick.read_as == "gamepad":
            self._controller = library.SDL_GameControllerOpen(index)
            if not self._controller:
                library.SDL_JoystickClose(self._joystick)
                self._refuse(NO_GAMEPAD)
        self._readers = tuple(self._as_gamepad() if self._controller else self._as_joystick())
        self.axes = tuple(reader.axis for reader in self._readers)
        self.pushed = ("left_x", "left_y") if self._controller else ("axis_0", "axis_1")
        if stick.strength is not None:
            from omnistudy.devices.handheld.sdl_motors import sdl_motors

            self.motors = sdl_motors(library, self._joystick, stick.strength.turned)
        self._last = tuple(axis.centre for axis in self.axes)
        self._lost = False

    def read(self) -> tuple[float, ...]:
        """Ask for the state of this moment."""
        self._sdl.SDL_JoystickUpdate()
        self._lost = not self._sdl.SDL_JoystickGetAttached(self._joystick)
        if not self._lost:
            self._last = tuple(float(reader.value()) for reader in self._readers)
        return self._last

    def trouble(self) -> str:
        """Tell whether it was unplugged."""
        return f"{self._attached.told()} was unplugged" if self._lost else ""

    def identity(self) -> Identity:
        """Tell its name and serial number."""
        return Identity(self._attached.name, self._attached.serial)

    def close(self) -> None:
        """Let go of it and of SDL."""
        if self.motors is not None:
            self.motors.close()
        if self._controller:
            self._sdl.SDL_GameControllerClose(self._controller)
        self._sdl.SDL_JoystickClose(self._joystick)
        stop_sdl(self._sdl)

    def _refuse(self, cause: str) -> None:
        remedy = "plug it in again, or choose another page (`omnistudy device list`)"
        raise CannotOpen(DEVICE, self._attached.told(), cause, remedy)

    def _as_gamepad(self) -> Sequence[_Reader]:
        library, controller = self._sdl, self._controller
        axes = [
            _Reader(
                HardwareAxis(name, 0.0 if "trigger" in name else LOW, 0.0, HIGH),
                _asker(library.SDL_GameControllerGetAxis, controller, number),
            )
            for number, name in enumerate(GAMEPAD_AXES)
        ]
        buttons = [
            _Reader(
                HardwareAxis(
                    library.SDL_GameControllerGetStringForButton(number).decode(), 0, 0, 1
                ),
                _asker(library.SDL_GameControllerGetButton, controller, number),
            )
            for number in range(library.SDL_CONTROLLER_BUTTON_MAX)
        ]
        return (*axes, *buttons)

    def _as_joystick(self) -> Sequence[_Reader]:
        library, joystick = self._sdl, self._joystick
        axes = [
            _Reader(
                HardwareAxis(f"axis_{number}", LOW, 0.0, HIGH),
                _asker(library.SDL_JoystickGetAxis, joystick, number),
            )
            for number in range(library.SDL_JoystickNumAxes(joystick))
        ]
        hats = [
            _Reader(HardwareAxis(f"hat_{number}_{way}", -1, 0, 1), self._hat(number, plus, minus))
            for number in range(library.SDL_JoystickNumHats(joystick))
            for way, plus, minus in (
                ("x", library.SDL_HAT_RIGHT, library.SDL_HAT_LEFT),
                ("y", library.SDL_HAT_DOWN, library.SDL_HAT_UP),
            )
        ]
        buttons = [
            _Reader(
                HardwareAxis(f"button_{number}", 0, 0, 1),
                _asker(library.SDL_JoystickGetButton, joystick, number),
            )
            for number in range(library.SDL_JoystickNumButtons(joystick))
        ]
        return (*axes, *hats, *buttons)

    def _hat(self, number: int, plus: int, minus: int) -> Callable[[], float]:
        def value() -> float:
            hat = self._sdl.SDL_JoystickGetHat(self._joystick, number)
            return float(bool(hat & plus)) - float(bool(hat & minus))

        return value


def _asker(ask: Callable[[Any, int], int], device: Any, number: int) -> Callable[[], float]:
    return lambda: float(ask(device, number))
