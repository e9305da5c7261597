"""Mistakes in reaching a gamepad, a bought stick, a space mouse or a keyboard."""

from __future__ import annotations

from collections.abc import Sequence

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class NoSuchAxis(OmnistudyError):
    """A mapping that names an axis which the device has not."""

    def __init__(self, name: str, there: Sequence[str]) -> None:
        super().__init__(
            f"the device has no axis '{name}': it has {', '.join(there) or 'none'}"
            f"{nearest(name, tuple(there))}"
        )


class NoDriver(OmnistudyError):
    """A library that speaks to such devices is not installed."""

    def __init__(self, device: str, library: str, remedy: str) -> None:
        super().__init__(f"device '{device}' needs {library}, which is not installed: {remedy}")


class NothingPluggedIn(OmnistudyError):
    """No device of the kind that was asked for."""

    def __init__(self, device: str, wanted: str, there: Sequence[str]) -> None:
        found = f"plugged in are {', '.join(there)}" if there else "nothing of its kind is there"
        asked = f" with {wanted}" if wanted else ""
        super().__init__(
            f"device '{device}'{asked} is not plugged in ({found}): plug it in, and see "
            "`omnistudy device list`"
        )


class WhichDevice(OmnistudyError):
    """Several devices fit what was asked for."""

    def __init__(self, device: str, there: Sequence[str]) -> None:
        super().__init__(
            f"several devices fit '{device}', say which by 'name' or 'serial' in its page: "
            f"{', '.join(there)}"
        )


class CannotOpen(OmnistudyError):
    """A device that is there but cannot be opened."""

    def __init__(self, device: str, what: str, cause: str, remedy: str) -> None:
        super().__init__(f"device '{device}': {what} cannot be opened ({cause}): {remedy}")


class NoKeys(OmnistudyError):
    """A keyboard outside a live session, where no page tells which keys are held."""

    def __init__(self) -> None:
        super().__init__(
            "device 'keyboard' reads the keys of the participant's page, which only a live session "
            "has: `omnistudy session run STUDY PARTICIPANT --live`"
        )


class NothingToCalibrate(OmnistudyError):
    """A device whose axes have no ranges to be found."""

    def __init__(self, device: str) -> None:
        super().__init__(
            f"device '{device}' has no axes whose ranges could be found: calibrate a gamepad, a "
            "stick or a space mouse, or the force of a serial stick with --force"
        )


class Unplugged(OmnistudyError):
    """A device that went away while it was calibrated."""

    def __init__(self, trouble: str) -> None:
        super().__init__(f"{trouble}: plug it in and begin again")


class DidNotMove(OmnistudyError):
    """An axis that stayed where it was while its device was held at an end."""

    def __init__(self, name: str, way: str, instead: str) -> None:
        hint = (
            f"'{instead}' moved: name it in the device's page"
            if instead and instead != name
            else ("hold it there until the next step is asked for")
        )
        super().__init__(f"axis '{name}' did not move while it was to be held {way}; {hint}")


class Unsteady(OmnistudyError):
    """An axis that strays at rest."""

    def __init__(self, name: str, share: float) -> None:
        super().__init__(
            f"axis '{name}' strayed by {share:.0%} of its way while nobody was to touch it: let go "
            "of it, and put it on a table that does not shake"
        )


class NoSuchDevice(OmnistudyError):
    """A device that is neither on a serial line nor bought, where one of these is needed."""

    def __init__(self, device: str, verb: str) -> None:
        super().__init__(
            f"device '{device}' is no hardware, there is nothing to {verb}: "
            "`omnistudy device list` names what is plugged in"
        )


class AnotherDevice(OmnistudyError):
    """A device that is not the one that was driven with before."""

    def __init__(self, model: str, serial: str, found: str, found_serial: str) -> None:
        before = f"'{model}'" + (f" (serial number {serial})" if serial else "")
        now = f"'{found}'" + (f" (serial number {found_serial})" if found_serial else "")
        super().__init__(
            f"{now} is plugged in where {before} was: plug that one in again, or begin another "
            "session"
        )


class NotAtRest(OmnistudyError):
    """A device that nobody let go of."""

    def __init__(self, seconds: float) -> None:
        super().__init__(
            f"the device did not come to rest within {seconds:g} s: let go of it, and calibrate it "
            "if it strays (`omnistudy device calibrate`)"
        )


class NoMotors(OmnistudyError):
    """A device whose force is to be measured, and that renders none."""

    def __init__(self, device: str) -> None:
        super().__init__(
            f"device '{device}' pushes along no axis: take a force-feedback stick, and give an "
            "'sdl_stick' its 'strength'"
        )


class NoForceFelt(OmnistudyError):
    """Readings that do not grow with the pushes."""

    def __init__(self, full: float, half_width: float) -> None:
        super().__init__(
            f"the readings do not grow with the pushes (a full one is {full:.3g} ± "
            f"{half_width:.2g} N): is the stick's power on, and does the instrument hold "
            "the handle?"
        )
