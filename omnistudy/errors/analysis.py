"""Mistakes in what is analysed and reported."""

from collections.abc import Iterable
from pathlib import Path

from omnistudy.errors.base import OmnistudyError


class UnequalColumns(OmnistudyError):
    """Two columns of one metric that do not belong together."""

    def __init__(self, metric: str, first: tuple[int, ...], second: tuple[int, ...]) -> None:
        super().__init__(
            f"{metric} was given columns of shapes {first} and {second}: "
            "give two one-dimensional columns of the same length"
        )


class MixedKinds(OmnistudyError):
    """Virtual and human participants in one analysis."""

    def __init__(self, study: str) -> None:
        super().__init__(
            f"study '{study}' holds virtual and human participants: simulated and human rows are "
            "never analysed together; put the virtual participants into a study of their own"
        )


class NotAnArmStudy(OmnistudyError):
    """A study offered as the arm-stiffness study that has no such factor."""

    def __init__(self, study: str, factor: str, factors: Iterable[str]) -> None:
        names = ", ".join(sorted(factors)) or "none"
        super().__init__(
            f"study '{study}' has no factor '{factor}' (its factors: {names}): give a study made "
            "from protocols/utah2017_arm_stiffness.yaml"
        )


class NoFolderForReport(OmnistudyError):
    """A page that would go into a folder that does not exist."""

    def __init__(self, page: Path) -> None:
        super().__init__(
            f"{page} cannot be written: there is no folder {page.parent}; make it first or choose "
            "another file with -o"
        )


class NotAReport(OmnistudyError):
    """A file that would be overwritten although no report of ours made it."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"{path} exists and is not a report of omnistudy: choose another file with -o, or "
            "move it away first"
        )
