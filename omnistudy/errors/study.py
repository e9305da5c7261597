"""Mistakes with studies: finding them, and keeping to what was frozen."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownStudy(OmnistudyError):
    """A study that is neither a file nor a name in the folder of studies."""

    def __init__(self, given: str, folder: Path, names: Iterable[str]) -> None:
        known = sorted(names)
        there = f"are {', '.join(known)}" if known else "are none yet"
        super().__init__(
            f"no study '{given}': give a name or the path of a .db, or make one with "
            f"`omnistudy study create`; the studies in '{folder}' {there}{nearest(given, known)}"
        )


class BadStudyName(OmnistudyError):
    """A study's name that would not do as a file's."""

    def __init__(self, given: str) -> None:
        super().__init__(
            f"'{given}' cannot be a study's name: use letters, digits, '-' and '_', such as pilot_2"
        )


class ProtocolChanged(OmnistudyError):
    """A protocol that is not the one frozen into the study."""

    def __init__(self, study: str, differences: Sequence[object]) -> None:
        lines = "\n  ".join(str(difference) for difference in differences)
        super().__init__(
            f"the protocol was changed after study '{study}' was frozen; put it back, or create "
            f"another study from it. What differs (frozen -> given):\n  {lines}"
        )


class UnknownParticipant(OmnistudyError):
    """A participant whom the study does not have."""

    def __init__(self, study: str, given: str, codes: Sequence[str]) -> None:
        known = ", ".join(codes) if codes else "none yet"
        super().__init__(
            f"study '{study}' has no participant '{given}': its participants are {known}"
            f"{nearest(given, codes)}"
        )
