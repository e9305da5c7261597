"""A force-feedback stick as Linux's event device tells it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from omnistudy.devices.device import Identity
from omnistudy.devices.handheld.axes import HardwareAxis
from omnistudy.devices.handheld.choice import Attached, the_one
from omnistudy.devices.handheld.evdev_motors import EvdevMotors
from omnistudy.devices.handheld.hardware import Hardware
from omnistudy.errors.handheld import CannotOpen, NoDriver

if TYPE_CHECKING:
    import evdev

    from omnistudy.devices.handheld.force_stick import ForceStick

DEVICE = "force_stick"


def _library() -> Any:
    try:
        import evdev
    except ImportError as cause:
        remedy = "pip install 'omnistudy[devices]' on Linux"
        raise NoDriver(DEVICE, "the Python package evdev", remedy) from cause
    return evdev


def attached_force_sticks() -> tuple[Attached, ...]:
    """List the event devices with a stick's axes and a constant force; raises NoDriver."""
    library = _library()
    found = []
    for path in library.list_devices():
        try:
            device = library.InputDevice(path)
        except OSError:
            continue  # unplugged between listing and opening
        if _is_force_stick(library, device):
            found.append(Attached(DEVICE, device.name, device.uniq, path))
        device.close()
    return tuple(found)


def _is_force_stick(library: Any, device: evdev.InputDevice[str]) -> bool:
    codes = library.ecodes
    can = device.capabilities(absinfo=False)
    return codes.FF_CONSTANT in can.get(codes.EV_FF, ()) and {codes.ABS_X, codes.ABS_Y} <= set(
        can.get(codes.EV_ABS, ())
    )


def open_force_stick(stick: ForceStick) -> EvdevHardware:
    """Open the one that is meant; raises NoDriver, NothingPluggedIn, WhichDevice, CannotOpen."""
    library = _library()
    chosen = the_one(DEVICE, attached_force_sticks(), stick.name, stick.serial)
    try:
        device = library.InputDevice(chosen.path)
    except OSError as cause:
        remedy = "add your user to the group 'input', then log in again"
        raise CannotOpen(DEVICE, chosen.told(), str(cause.strerror), remedy) from cause
    return EvdevHardware(library, device, chosen, stick.strength.turned)


class EvdevHardware(Hardware):
    """Events, all of which are taken in at each `read`; each changes one axis or button."""

    pushed = ("ABS_X", "ABS_Y")

    def __init__(
        self, library: Any, device: evdev.InputDevice[str], attached: Attached, turned: bool
    ) -> None:
        self._library = library
        self._device = device
        self._attached = attached
        self._lost = False
        self._places: dict[tuple[int, int], int] = {}
        self.axes = tuple(self._found_axes())
        self._now = [0.0] * len(self.axes)
        self._ask_for_all()
        self.motors = EvdevMotors(library, device, turned)

    def _found_axes(self) -> Iterator[HardwareAxis]:
        """Name axes, then buttons, and note the place of each."""
        codes = self._library.ecodes
        can: Any = self._device.capabilities()
        for code, info in can.get(codes.EV_ABS, ()):
            self._places[codes.EV_ABS, code] = len(self._places)
            middle = 0.5 * (info.min + info.max)
            yield HardwareAxis(_name(codes.ABS[code]), info.min, middle, info.max)
        for code in can.get(codes.EV_KEY, ()):
            self._places[codes.EV_KEY, code] = len(self._places)
            yield HardwareAxis(_name(codes.BTN.get(code, f"KEY_{code}")), 0, 0, 1)

    def read(self) -> tuple[float, ...]:
        """Take in all events."""
        try:
            while not self._lost:
                for event in self._device.read():
                    self._take(event)
        except BlockingIOError:
            pass  # nothing is left to read
        except OSError:
            self._lost = True
        return tuple(self._now)

    def trouble(self) -> str:
        """Tell whether it was unplugged."""
        return f"{self._attached.told()} was unplugged" if self._lost else ""

    def identity(self) -> Identity:
        """Tell its name and serial number."""
        return Identity(self._attached.name, self._attached.serial)

    def close(self) -> None:
        """Let go of it; Linux removes what effects were left."""
        if self.motors is not None:
            self.motors.close()
        self._device.close()

    def _take(self, event: evdev.InputEvent) -> None:
        codes = self._library.ecodes
        if (event.type, event.code) == (codes.EV_SYN, codes.SYN_DROPPED):
            self._ask_for_all()
            return
        place = self._places.get((event.type, event.code))
        if place is not None:
            self._now[place] = float(event.value)

    def _ask_for_all(self) -> None:
        """Ask where everything is now: at first, and after events were lost."""
        codes = self._library.ecodes
        held = set(self._device.active_keys())
        for (kind, code), place in self._places.items():
            if kind == codes.EV_ABS:
                self._now[place] = float(self._device.absinfo(code).value)
            else:
                self._now[place] = float(code in held)


def _name(names: Any) -> str:
    """Give the first of the names that Linux has for a code."""
    return str(names[0] if isinstance(names, tuple | list) else names)
