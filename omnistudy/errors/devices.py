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
    """A device that took its force away, or must not be driven with, during a trial."""

    def __init__(self, trouble: str) -> None:
        super().__init__(
            f"the device went soft during the trial: {trouble}; find the cause, have it checked "
            "and repeat the trial"
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


class NotReached(OmnistudyError):
    """What a device's process said when it could not connect its device."""


class DeviceProcessFailed(OmnistudyError):
    """A device whose process did not start, or ended by itself."""

    def __init__(self, kind: str, exit_code: int | None = None) -> None:
        how = "did not start" if exit_code is None else f"ended with exit code {exit_code}"
        super().__init__(
            f"the process that turns device '{kind}' {how}: the stick goes soft by itself; look at "
            "what was printed before, then run the trial again"
        )


class DeviceSilent(OmnistudyError):
    """A device whose process says nothing any more."""

    def __init__(self, kind: str, seconds: float) -> None:
        super().__init__(
            f"the process that turns device '{kind}' said nothing for {seconds:g} s: the machine "
            "may be too busy; close other programs, then run the trial again"
        )


class OnlyLive(OmnistudyError):
    """A device of the real world, asked to run in simulated time."""

    def __init__(self, kind: str) -> None:
        super().__init__(
            f"device '{kind}' lives in real time, which nobody can stop or hasten: "
            "run the trials with `omnistudy session run STUDY --live`, or choose a simulated one"
        )


class NobodyHolds(OmnistudyError):
    """A real person and a device that exists in the computer alone."""

    def __init__(self, operator: str, device: str) -> None:
        super().__init__(
            f"operator '{operator}' is a person, and no person can hold the simulated device "
            f"'{device}': choose a real device, or let operator 'virtual_driver' hold it"
        )
