"""Mistakes in reaching a device."""

from __future__ import annotations

from collections.abc import Sequence

from omnistudy.errors.base import OmnistudyError


class NoToolchain(OmnistudyError):
    """The emulator's tools are not installed."""

    def __init__(self, missing: Sequence[str], packages: Sequence[str]) -> None:
        super().__init__(
            f"the emulated stick needs {', '.join(missing)}: "
            f"apt-get install {' '.join(packages)}, or `make system-packages`"
        )


class ToolchainFailed(OmnistudyError):
    """The firmware or the emulator does not compile."""

    def __init__(self, command: str, said: str) -> None:
        super().__init__(f"the firmware or its emulator does not compile; `{command}` said: {said}")


class NoFirmware(OmnistudyError):
    """The firmware's sources are not where they should be."""

    def __init__(self, folder: object) -> None:
        super().__init__(f"the firmware's sources are not in {folder}: install omnistudy anew")


class ProcessorCrashed(OmnistudyError):
    """The emulated processor stopped: an illegal instruction or a jump into nothing."""

    def __init__(self, cycle: int) -> None:
        super().__init__(
            f"the emulated processor crashed at cycle {cycle}: the firmware has a bug, "
            "see firmware/README.md"
        )


class NoAnswer(OmnistudyError):
    """A request that the stick did not answer in time."""

    def __init__(self, request: str, seconds: float) -> None:
        super().__init__(
            f"the stick did not answer '{request}' within {seconds:g} s: "
            "check its cable, power and port, then try again"
        )


class Refused(OmnistudyError):
    """A request that the stick refused."""

    def __init__(self, request: str, reason: str) -> None:
        super().__init__(f"the stick refused '{request}': {reason}")


class CannotBePrescribed(OmnistudyError):
    """A device with a mechanism of its own, moved by an operator that only knows positions."""

    def __init__(self, device: str) -> None:
        super().__init__(
            f"device '{device}' has a mechanism that a hand moves; a recorded operator prescribes "
            "positions: use device 'simulated_stick' or 'direct' for it"
        )


class WentSoft(OmnistudyError):
    """A stick that took its force away during a trial."""

    def __init__(self, state: str, faults: str) -> None:
        super().__init__(
            f"the stick went soft during the trial (state {state}; {faults}): "
            "find the cause, clear the faults and repeat the trial"
        )


class WrongProtocol(OmnistudyError):
    """A stick that speaks another version of the protocol."""

    def __init__(self, theirs: int, ours: int) -> None:
        super().__init__(
            f"the stick speaks protocol version {theirs}, this omnistudy speaks {ours}: "
            "flash the firmware of this release (firmware/README.md)"
        )


class NoPort(OmnistudyError):
    """A serial port that cannot be opened."""

    def __init__(self, path: str, cause: str, attached: Sequence[str]) -> None:
        there = f"attached are {', '.join(attached)}" if attached else "no stick is attached"
        super().__init__(f"the port {path} cannot be opened ({cause}): {there}")


class WhichPort(OmnistudyError):
    """No port was named, and there is none or more than one."""

    def __init__(self, attached: Sequence[str]) -> None:
        if attached:
            super().__init__(f"several serial ports are attached, name one: {', '.join(attached)}")
        else:
            super().__init__(
                "no stick is attached: plug one in, or try `omnistudy device emulate` and name the "
                "port that it prints"
            )


class PortLost(OmnistudyError):
    """A serial port that went away while it was in use."""

    def __init__(self, path: str) -> None:
        super().__init__(f"the stick at {path} was unplugged: plug it in again and check it")


class NoTelemetry(OmnistudyError):
    """A port at which nothing speaks our protocol."""

    def __init__(self, seconds: float) -> None:
        super().__init__(
            f"nothing that speaks the stick's protocol was heard for {seconds:g} s: "
            "check power and port, and that the firmware is flashed (firmware/README.md)"
        )
