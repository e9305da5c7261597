"""Mistakes in where a picture is to go."""

from collections.abc import Iterable
from pathlib import Path

from omnistudy.errors.base import OmnistudyError


class UnknownPictureFormat(OmnistudyError):
    """A picture file with a suffix that cannot be drawn."""

    def __init__(self, path: Path, allowed: Iterable[str]) -> None:
        super().__init__(f"{path}: pictures can be {' or '.join(allowed)}; give one of these names")


class PictureNotWritten(OmnistudyError):
    """A picture that its folder or disk does not take."""

    def __init__(self, path: Path, cause: str) -> None:
        super().__init__(
            f"{path} cannot be written ({cause}): give a file in a folder that exists and is yours"
        )


class PictureExists(OmnistudyError):
    """A picture that would overwrite a file."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path} exists already: give another name, or --force to replace it")
