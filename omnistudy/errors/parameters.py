"""Mistakes in parameters that are given on the command line."""

from collections.abc import Iterable, Sequence

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class NotASetting(OmnistudyError):
    """A `--set` that is not `name=value`."""

    def __init__(self, given: str) -> None:
        super().__init__(f"--set {given}: write name=value, for example --set boundary.layer_x=0.2")


class UnknownParameter(OmnistudyError):
    """A parameter that the kind does not have."""

    def __init__(self, kind: str, given: str, allowed: Iterable[str]) -> None:
        names = sorted(allowed)
        has = f"its parameters are {', '.join(names)}" if names else "it has none"
        super().__init__(f"'{kind}' has no parameter '{given}': {has}{nearest(given, names)}")


class BadParameter(OmnistudyError):
    """Values that the kind's parameters do not allow."""

    def __init__(self, kind: str, faults: Sequence[str]) -> None:
        super().__init__(f"'{kind}' cannot be made: {'; '.join(faults)}")
