"""Mistakes in starting something of one's own."""

from pathlib import Path

from omnistudy.errors.base import OmnistudyError


class BadName(OmnistudyError):
    """A name that code, files and tables cannot call a thing."""

    def __init__(self, given: str, fault: str) -> None:
        super().__init__(f"'{given}' cannot be a name: {fault}")


class TakenName(OmnistudyError):
    """A name that something already has."""

    def __init__(self, noun: str, given: str) -> None:
        super().__init__(
            f"there is a {noun} '{given}' already (`omnistudy {noun} show {given}`): choose "
            "another name"
        )


class FileInTheWay(OmnistudyError):
    """A file that would have to be overwritten."""

    def __init__(self, file: Path) -> None:
        super().__init__(
            f"{file} is there already and is never overwritten: choose another name or folder"
        )


class UnusablePyproject(OmnistudyError):
    """A pyproject.toml that no law or controller can be announced in."""

    def __init__(self, file: Path, fault: str, remedy: str) -> None:
        super().__init__(f"{file}: {fault}; {remedy}")


class LabNotWritten(OmnistudyError):
    """Files that the system does not let be written."""

    def __init__(self, file: Path, reason: str) -> None:
        super().__init__(
            f"{file} cannot be written ({reason}), so nothing was: name a folder that you may "
            "write to with --into"
        )
