"""Mistakes in driving without a study."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownPart(OmnistudyError):
    """A page that no configuration folder has."""

    def __init__(self, group: str, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"no {group} '{given}': the pages in conf/{group} are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )


class BrokenPart(OmnistudyError):
    """A page that does not say a part; one sentence a fault."""

    def __init__(self, faults: Sequence[str]) -> None:
        super().__init__("\n".join(faults))


class NotAColumn(OmnistudyError):
    """A mapping of columns that cannot be understood."""

    def __init__(self, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"'{given}' maps no column: write one of {', '.join(allowed)}, '=', and the name of a "
            f"column in the file, such as {allowed[0]}=stamp"
        )


class NothingMapped(OmnistudyError):
    """A file that lacks a column without which it says nothing."""

    def __init__(self, what: str, needed: str, option: str) -> None:
        super().__init__(
            f"{what} needs columns for {needed}: give {option} WHAT=NAME for what is 'none'"
        )


class NoCommonTime(OmnistudyError):
    """A recording and an odometry that do not overlap in time."""

    def __init__(
        self, commands: tuple[float, float], odometry: Path, seen: tuple[float, float]
    ) -> None:
        super().__init__(
            f"the commands move from {commands[0]:.3f} s to {commands[1]:.3f} s, but the odometry "
            f"{odometry} lasts from {seen[0]:.3f} s to {seen[1]:.3f} s: give the odometry of the "
            "same drive, stamped by the same clock in seconds"
        )


class NotABarnFolder(OmnistudyError):
    """A folder without worlds of the BARN benchmark."""

    def __init__(self, folder: Path) -> None:
        super().__init__(
            f"{folder} holds no world_N.world: give the folder of BARN worlds, with path_N.npy "
            "beside each"
        )
