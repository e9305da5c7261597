"""Mistakes in the files that hold a person's recorded drive."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class NoRecording(OmnistudyError):
    """A recording that is not there or cannot be read as text."""

    def __init__(self, file: Path, fault: str) -> None:
        super().__init__(
            f"recording {file}: {fault}; give a CSV file whose first line names its columns"
        )


class NoSuchColumn(OmnistudyError):
    """A column that the recording does not have."""

    def __init__(self, file: Path, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"recording {file} has no column '{given}': its columns are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )


class NotANumber(OmnistudyError):
    """A cell of a recording that is no finite number."""

    def __init__(self, file: Path, line: int, column: str, given: str) -> None:
        super().__init__(
            f"recording {file}, line {line}: '{given}' in column '{column}' is not a finite "
            "number; mend or remove the line"
        )


class TimeRunsBackwards(OmnistudyError):
    """A row of a recording that is older than the one before it."""

    def __init__(self, file: Path, line: int, before: float, given: float) -> None:
        super().__init__(
            f"recording {file}, line {line}: time runs backwards from {before:.6f} s to "
            f"{given:.6f} s; sort the rows, or split the file where a new recording begins"
        )


class NoRows(OmnistudyError):
    """A recording with a heading and nothing under it."""

    def __init__(self, file: Path) -> None:
        super().__init__(f"recording {file} holds no rows under its heading: record again")


class NoMotion(OmnistudyError):
    """A recording in which nothing is ever asked for."""

    def __init__(self, file: Path, columns: Sequence[str]) -> None:
        super().__init__(
            f"recording {file} holds no motion: {' and '.join(columns)} are zero in every row; "
            "check which columns hold the commands"
        )


class WrongAxes(OmnistudyError):
    """An operator whose hand does not fit the device."""

    def __init__(self, given: int, axes: Sequence[str]) -> None:
        super().__init__(
            f"the operator moves {given} axes, but the device has {len(axes)} "
            f"({', '.join(axes)}): name a column or null for each axis of the device"
        )
