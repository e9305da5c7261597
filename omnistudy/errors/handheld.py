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
