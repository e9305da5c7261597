"""Mistakes in arms, their tasks and their runs."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownArm(OmnistudyError):
    """An arm that is neither a file nor a name in a configuration folder."""

    def __init__(self, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"no arm '{given}': there is no such file, and the arms are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )


class UnknownArmTask(OmnistudyError):
    """A task that is neither a file nor a name in a configuration folder."""

    def __init__(self, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"no arm task '{given}': there is no such file, and the tasks are "
            f"{', '.join(allowed)}{nearest(given, allowed)}"
        )


class BrokenArmPage(OmnistudyError):
    """A page that does not say an arm or a task; one sentence a fault."""

    def __init__(self, page: Path, faults: Sequence[str]) -> None:
        super().__init__("\n".join(faults))
        self.page = page
        self.faults = tuple(faults)


class BadGuidance(OmnistudyError):
    """A device with a number of axes that leads no arm."""

    def __init__(self, given: int) -> None:
        super().__init__(
            f"an arm was led by {given} numbers: give 6 (the hand's twist), 7 (and the bearing of "
            "its path) or 10 (and x, y, theta of the chair's goal)"
        )
