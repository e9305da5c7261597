"""Mistakes in where a picture is to go."""

from collections.abc import Iterable
from pathlib import Path

from omnistudy.errors.base import OmnistudyError


class UnknownPictureFormat(OmnistudyError):
    """A picture file with a suffix that cannot be drawn."""

    def __init__(self, path: Path, allowed: Iterable[str]) -> None:
        super().__init__(f"{path}: pictures can be {' or '.join(allowed)}; give one of these names")


class PictureExists(OmnistudyError):
    """A picture that would overwrite a file."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path} exists already: give another name, or --force to replace it")
