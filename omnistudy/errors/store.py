"""Mistakes and mishaps with study databases."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class StudyExists(OmnistudyError):
    """A new study whose file is already there."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"'{path}' exists already and is never overwritten: choose another name, or move it "
            "away"
        )


class StudyNotFound(OmnistudyError):
    """A study database that is not where it was looked for."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"there is no study database '{path}': check the name, or make it with "
            "`omnistudy study create`"
        )


class NotAStudy(OmnistudyError):
    """A sound SQLite file that omnistudy did not make."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"'{path}' is a SQLite database, but not a study of omnistudy: give the file that "
            "`omnistudy study create` made"
        )


class DatabaseTooOld(OmnistudyError):
    """A study database made by an earlier omnistudy."""

    def __init__(self, path: Path, revision: str, needed: str) -> None:
        super().__init__(
            f"'{path}' was made by an older omnistudy (revision {revision}, needed is {needed}): "
            f"type `omnistudy study upgrade {path}`, which copies it first"
        )


class DatabaseTooNew(OmnistudyError):
    """A study database made by a later omnistudy."""

    def __init__(self, path: Path, revision: str, known: str) -> None:
        super().__init__(
            f"'{path}' was made by a newer omnistudy (revision {revision}, the newest known here "
            f"is {known}): update omnistudy"
        )


class DatabaseDamaged(OmnistudyError):
    """A file that is no whole SQLite database, or whose bytes are not those once written."""

    def __init__(self, path: Path, cause: str) -> None:
        super().__init__(
            f"'{path}' is damaged ({cause}): restore it from a backup; leave this file as it is "
            "until that is done"
        )


class StoreFull(OmnistudyError):
    """No room left for what was to be written; all of it was left out."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"no room left on the disk while writing '{path}'; nothing was half-written: free some "
            "room, then run the same command again"
        )


class DiskFailed(OmnistudyError):
    """The disk refused to give or take bytes."""

    def __init__(self, path: Path, cause: str) -> None:
        super().__init__(
            f"the disk failed at '{path}' ({cause}); nothing was half-written: check the disk, and "
            "never keep a study on a network share"
        )


class StudyBusy(OmnistudyError):
    """Another process has the study open to write."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"another program has '{path}' open to write, such as a running session: wait until it "
            "is done"
        )


class NotWritable(OmnistudyError):
    """A file or folder that may not be written, or a database opened to read."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"'{path}' cannot be written: check the rights of the file and of its folder"
        )


class WrongTrialStatus(OmnistudyError):
    """A trial that is not in the state that an action needs."""

    def __init__(self, trial: int, status: str, action: str, needed: Sequence[str]) -> None:
        super().__init__(
            f"trial {trial} is {status} and cannot be {action}: it would have to be "
            f"{' or '.join(needed)}"
        )


class NoSuchTrial(OmnistudyError):
    """A trial number that the study does not have."""

    def __init__(self, path: Path, given: int) -> None:
        super().__init__(
            f"'{path}' has no trial {given}: the column `trial` of `trials()` lists them"
        )


class NoSuchStream(OmnistudyError):
    """A stream that a trial does not have."""

    def __init__(self, trial: int, given: str, allowed: Sequence[str]) -> None:
        has = f"its streams are {', '.join(allowed)}" if allowed else "it has none"
        super().__init__(f"trial {trial} has no stream '{given}': {has}{nearest(given, allowed)}")


class RecorderFailed(OmnistudyError):
    """A recorder that did not start."""

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"the process that records into {path} did not start: look at what was printed before, "
            "free memory or disk, then run the session again"
        )
