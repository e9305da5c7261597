"""Mistakes in protocols."""

from collections.abc import Iterable, Sequence

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownProtocol(OmnistudyError):
    """A protocol that is neither a file nor a name in any folder of protocols."""

    def __init__(self, given: str, allowed: Iterable[str]) -> None:
        names = sorted(allowed)
        super().__init__(
            f"no protocol '{given}': give a YAML file that exists or one of {', '.join(names)}"
            f"{nearest(given, names)}"
        )


class ProtocolFaults(OmnistudyError):
    """A protocol that cannot be run; every fault that was found, one line each."""

    def __init__(self, where: str, faults: Sequence[str]) -> None:
        if len(faults) == 1:
            message = f"{where}: {faults[0]}"
        else:
            message = "\n  ".join([f"{where} has {len(faults)} faults:", *faults])
        super().__init__(message)
        self.where = where
        self.faults = tuple(faults)


class UnknownCondition(OmnistudyError):
    """A condition that the protocol does not have."""

    def __init__(self, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"no condition '{given}': the conditions are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )
