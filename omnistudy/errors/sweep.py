"""Mistakes in sweeps: what is asked, what is there, what runs it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class NotASweepOverride(OmnistudyError):
    """A word that Hydra's grammar does not read as KEY=VALUES."""

    def __init__(self, given: str) -> None:
        super().__init__(
            f"'{given}' is no KEY=VALUES: write a list as law.stiffness.x=100,200, steps as "
            "range(100,300,50), or interval(100,300) with --samples"
        )


class NoValues(OmnistudyError):
    """A key with nothing behind the equals sign."""

    def __init__(self, key: str) -> None:
        super().__init__(f"{key} is given no values: write them as {key}=100,200 or range(1,5)")


class SweptTwice(OmnistudyError):
    """A key that is given more than once."""

    def __init__(self, key: str) -> None:
        super().__init__(f"{key} is given twice: put all of its values into one list")


class NothingSwept(OmnistudyError):
    """A sweep in which every key has one value."""

    def __init__(self) -> None:
        super().__init__(
            "no key has more than one value, so there is nothing to sweep: give at least one list, "
            "such as law.stiffness.x=100,200"
        )


class IntervalNeedsSamples(OmnistudyError):
    """An interval without a number of samples."""

    def __init__(self, key: str) -> None:
        super().__init__(
            f"{key} is an interval: say with --samples how many points are drawn from it"
        )


class SamplesNeedInterval(OmnistudyError):
    """A number of samples where nothing is sampled."""

    def __init__(self) -> None:
        super().__init__(
            "--samples is given, but no key is an interval: leave it out, or write a key as "
            "interval(100,300)"
        )


class EmptyInterval(OmnistudyError):
    """An interval that ends before it begins."""

    def __init__(self, key: str, low: float, high: float) -> None:
        super().__init__(f"{key}=interval({low:g},{high:g}) is empty: give the smaller end first")


class RoleOfNoKey(OmnistudyError):
    """A role for a key that is not swept."""

    def __init__(self, option: str, key: str, swept: Sequence[str]) -> None:
        super().__init__(
            f"{option} {key}: this key is not swept; the keys are {', '.join(swept)}"
            f"{nearest(key, swept)}"
        )


class KeyChangesNothing(OmnistudyError):
    """A swept key that changes no set-up that is driven."""

    def __init__(self, key: str, conditions: Sequence[str]) -> None:
        super().__init__(
            f"{key} changes nothing in the set-up of the conditions {', '.join(conditions)}: "
            "sweep a key of world, plant, device, controller, law, operator, task or recording "
            "that one of them uses, or choose another with --condition (participants, routes and "
            "orders are the same at every point)"
        )


class NoTrialsOfConditions(OmnistudyError):
    """Conditions that nobody meets."""

    def __init__(self, conditions: Sequence[str], participants: int) -> None:
        super().__init__(
            f"none of the first {participants} participants meets {', '.join(conditions)} in a "
            "main trial: choose other conditions with --condition, or more --participants"
        )


class TooManyParticipants(OmnistudyError):
    """More participants than the protocol plans for."""

    def __init__(self, asked: int, count: int) -> None:
        super().__init__(
            f"--participants {asked}: the protocol plans {count}; give fewer, or add "
            f"participants.count={asked}"
        )


class HumanSweep(OmnistudyError):
    """A protocol for people, asked to be swept."""

    def __init__(self, protocol: str) -> None:
        super().__init__(
            f"protocol '{protocol}' is for human participants, and only virtual ones can be "
            "swept: add participants.kind=virtual with a study_key and a participant_key"
        )


class AdaptiveOrder(OmnistudyError):
    """A protocol whose conditions are chosen while it runs."""

    def __init__(self, protocol: str) -> None:
        super().__init__(
            f"protocol '{protocol}' has an order that chooses conditions while it runs, so points "
            "could not meet the same trials: sweep it with a planned order, such as order=rotated"
        )


class BadSweepName(OmnistudyError):
    """A sweep's name that would not do as a folder's."""

    def __init__(self, given: str) -> None:
        super().__init__(
            f"'{given}' cannot be a sweep's name: use letters, digits, '-' and '_', such as gains_2"
        )


class AnotherQuestion(OmnistudyError):
    """A sweep's name that stands for another question already."""

    def __init__(self, name: str, differing: Sequence[str]) -> None:
        super().__init__(
            f"sweep '{name}' asks another question already (what differs: "
            f"{', '.join(differing)}): give another --name, or repeat the first command to go on"
        )


class UnknownSweep(OmnistudyError):
    """A sweep that is not in the folder of sweeps."""

    def __init__(self, given: str, folder: Path, names: Iterable[str]) -> None:
        known = sorted(names)
        there = f"are {', '.join(known)}" if known else "are none yet"
        super().__init__(
            f"no sweep '{given}': the sweeps in '{folder}' {there}{nearest(given, known)}"
        )


class WhichSweep(OmnistudyError):
    """A row without a sweep where there is not exactly one."""

    def __init__(self, folder: Path, names: Iterable[str]) -> None:
        known = sorted(names)
        there = f"are {', '.join(known)}" if known else "are none yet"
        super().__init__(f"say which sweep with --sweep NAME: the sweeps in '{folder}' {there}")


class BrokenSweep(OmnistudyError):
    """A sweep's file that cannot be read."""

    def __init__(self, path: Path, cause: str) -> None:
        super().__init__(
            f"{path} cannot be read as a sweep's file ({cause}): move it away; a results file is "
            "made again by the next run"
        )


class NothingRanYet(OmnistudyError):
    """A sweep without a finished point."""

    def __init__(self, name: str) -> None:
        super().__init__(f"sweep '{name}' has no finished point yet: repeat its command to run it")


class NoCompletePoint(OmnistudyError):
    """A sweep in which no design point met all of the nuisance."""

    def __init__(self, nuisances: int) -> None:
        super().__init__(
            f"no design point was driven over all {nuisances} nuisance points yet, and others "
            "cannot be compared: repeat the sweep's command to go on"
        )


class RowOutOfRange(OmnistudyError):
    """A row that the sweep does not have."""

    def __init__(self, row: int, rows: Sequence[int]) -> None:
        super().__init__(
            f"there is no row {row}: `omnistudy sweep show` lists rows {min(rows)} to {max(rows)}"
        )


class JobsFailed(OmnistudyError):
    """Points that could not be driven; the others are finished."""

    def __init__(self, name: str, failed: int, first: str, folder: Path) -> None:
        what = "1 point" if failed == 1 else f"{failed} points"
        super().__init__(
            f"{what} of sweep '{name}' failed, the first with: {first}; the others are kept, the "
            f"errors are in '{folder}', and the same command tries them again"
        )


class UnknownLauncher(OmnistudyError):
    """A launcher that nobody knows."""

    def __init__(self, given: str, known: Sequence[str]) -> None:
        super().__init__(
            f"unknown launcher '{given}': the launchers are {', '.join(known)}"
            f"{nearest(given, known)}"
        )


class LauncherNotInstalled(OmnistudyError):
    """A launcher whose package is not there."""

    def __init__(self, launcher: str, extra: str) -> None:
        super().__init__(
            f"the launcher '{launcher}' is not installed: pip install 'omnistudy[{extra}]'"
        )


class LauncherFailed(OmnistudyError):
    """A launcher that gave up."""

    def __init__(self, launcher: str, cause: str) -> None:
        super().__init__(
            f"the launcher '{launcher}' stopped ({cause}); what was finished is kept: mend that, "
            "or choose another --launcher, and the same command goes on"
        )


class OptunaNotInstalled(OmnistudyError):
    """A search without its package."""

    def __init__(self) -> None:
        super().__init__("--search optuna is not installed: pip install 'omnistudy[optuna]'")


class SearchNeedsSamples(OmnistudyError):
    """A search that is not told how long to go on."""

    def __init__(self) -> None:
        super().__init__("--search optuna needs --samples: how many design points it may try")


class NothingToSearch(OmnistudyError):
    """A search in which nothing can be chosen."""

    def __init__(self) -> None:
        super().__init__(
            "--search optuna needs a design key with several values: every key given is a nuisance"
        )


class ObjectiveNotRecorded(OmnistudyError):
    """An outcome that these trials do not have."""

    def __init__(self, column: str) -> None:
        super().__init__(
            f"{column} is not recorded in these trials (the device has no motor channels, or "
            "nothing was ever commanded): choose another outcome"
        )


class UnknownOutcome(OmnistudyError):
    """A column that is no outcome."""

    def __init__(self, given: str, known: Sequence[str]) -> None:
        super().__init__(
            f"'{given}' is no outcome of a sweep: the outcomes are {', '.join(known)}"
            f"{nearest(given, known)}"
        )


class ForeignFolder(OmnistudyError):
    """A page that could not find the protocol it rests on."""

    def __init__(self, page: Path, folder: Path) -> None:
        super().__init__(
            f"{page} would not find the protocol it rests on, which was given as a file: write it "
            f"into '{folder}'"
        )


class PageExists(OmnistudyError):
    """A page that would overwrite a file."""

    def __init__(self, page: Path) -> None:
        super().__init__(f"{page} exists already: give another name, or --force to replace it")


class PageNotWritten(OmnistudyError):
    """A page that its folder does not take, or under a name that cannot be a protocol's."""

    def __init__(self, page: Path, cause: str) -> None:
        super().__init__(f"{page} cannot be written: {cause}")


class ProtocolMoved(OmnistudyError):
    """A protocol that is no longer what the sweep ran."""

    def __init__(self, protocol: str, paths: Sequence[str]) -> None:
        super().__init__(
            f"protocol '{protocol}' is no longer what the sweep ran (changed: {', '.join(paths)}): "
            "put it back, or sweep it again"
        )
