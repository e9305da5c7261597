"""Mistakes in the naming of kinds and of the lab's folder."""

from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path

from omnistudy.errors.base import OmnistudyError


def nearest(given: str, allowed: Iterable[str]) -> str:
    """Say which allowed name is closest to the one given, or nothing when none is close."""
    close = get_close_matches(given, list(allowed), n=1, cutoff=0.5)
    return f"; did you mean '{close[0]}'?" if close else ""


class UnknownKind(OmnistudyError):
    """A `kind:` that no room and no installed package offers."""

    def __init__(self, group: str, given: str, allowed: Iterable[str]) -> None:
        names = sorted(allowed)
        super().__init__(
            f"unknown kind '{given}' in {group}: the kinds are {', '.join(names)}"
            f"{nearest(given, names)}"
        )
        self.group = group
        self.given = given


class UnknownKindOrPage(OmnistudyError):
    """A name that is neither a kind nor a page of its group."""

    def __init__(self, group: str, given: str, allowed: Iterable[str]) -> None:
        names = sorted(allowed)
        super().__init__(
            f"no kind and no page '{given}' in {group}: there are {', '.join(names)}"
            f"{nearest(given, names)}"
        )


class PageOfUnknownKind(OmnistudyError):
    """A page whose `kind:` no room and no installed package offers."""

    def __init__(self, file: Path, kind: str, group: str, allowed: Iterable[str]) -> None:
        names = sorted(allowed)
        super().__init__(
            f"{file} is of the kind '{kind}', but the kinds of {group} are {', '.join(names)}: "
            f"install the package that announces it, or mend the page{nearest(kind, names)}"
        )


class BrokenKind(OmnistudyError):
    """A kind that is announced by an installed package but cannot be loaded."""

    def __init__(self, group: str, kind: str, cause: str) -> None:
        super().__init__(
            f"kind '{kind}' in {group} is announced by an installed package but does not load "
            f"({cause}): mend or uninstall that package"
        )


class NoLabFolder(OmnistudyError):
    """A lab's folder that is named but not there."""

    def __init__(self, folder: Path, named_by: str) -> None:
        super().__init__(
            f"{named_by} names the folder '{folder}', which does not exist: create it or name "
            f"another"
        )
