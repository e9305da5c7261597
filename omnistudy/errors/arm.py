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
            "its path), 10 (and x, y, theta of the chair's goal) or 18 and more (and the chair's "
            "drive and turn, the part of the twist that corrects, and rates of all joints)"
        )


class ImpossibleStart(OmnistudyError):
    """A task that starts where its arm cannot be."""

    def __init__(self, fault: str) -> None:
        super().__init__(f"the task cannot start: {fault}; mend 'start.joints' on its page")


class ImpossibleTask(OmnistudyError):
    """A task that no chair pose makes possible."""

    def __init__(
        self,
        motion: str,
        answer: str,
        remedy: str = "move its goal, or run it anyway with --unchecked",
    ) -> None:
        super().__init__(f"motion '{motion}' is refused before anything moves: {answer}; {remedy}")
        self.motion = motion


class BrokenRun(OmnistudyError):
    """A file that does not hold a run of an arm."""

    def __init__(self, file: Path, fault: str) -> None:
        super().__init__(f"{file}: {fault}; give what `omnistudy arm solve` wrote")


class RunExists(OmnistudyError):
    """A file that a run or a URDF would overwrite."""

    def __init__(self, file: Path) -> None:
        super().__init__(f"{file} exists already: give another name, or --force to replace it")


class RunNotWritten(OmnistudyError):
    """A file that the system does not let be written."""

    def __init__(self, file: Path, reason: str) -> None:
        super().__init__(
            f"{file} cannot be written ({reason}): give a file in a folder that exists"
        )


class NotAnArmController(OmnistudyError):
    """A controller that cannot lead an arm."""

    def __init__(self, kind: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"controller '{kind}' leads no arm: those that do are {', '.join(allowed)}; its state "
            "must have a report of each step"
        )


class TooManySteps(OmnistudyError):
    """A motion so slow that its run would never end."""

    def __init__(self, motion: str, duration: float, step: float, most: int) -> None:
        super().__init__(
            f"motion '{motion}' would take {duration:.0f} s, which is {duration / step:.0f} steps "
            f"of {step:g} s: at most {most} can be run; raise its speed or the task's step"
        )
