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


class OrderDiffers(OmnistudyError):
    """A trial that is not the one that the protocol plans in its place."""

    def __init__(self, study: str, participant: str, position: int) -> None:
        super().__init__(
            f"study '{study}': trial {position} of {participant} is not the one that the frozen "
            "protocol plans in its place, so the database was changed: nothing was run; go back to "
            "a copy of the study"
        )


class DesignChanged(OmnistudyError):
    """An amendment that would change the design of a study."""

    def __init__(self, study: str, differences: Sequence[object]) -> None:
        lines = "\n  ".join(str(difference) for difference in differences)
        super().__init__(
            f"the amendment changes the design of study '{study}', whose allocation is drawn: put "
            "that back (site, texts, device and masked labels may change), or create another study "
            f"from it. What differs (frozen -> given):\n  {lines}"
        )


class NothingAmended(OmnistudyError):
    """An amendment without a difference."""

    def __init__(self, study: str) -> None:
        super().__init__(
            f"the protocol is the one that study '{study}' has already: there is nothing to amend"
        )
