"""Mistakes in worlds, their files and their routes."""

from collections.abc import Sequence

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownRoute(OmnistudyError):
    """A route that the world does not have."""

    def __init__(self, world: str, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"world '{world}' has no route '{given}': its routes are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )
