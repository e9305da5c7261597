"""Mistakes in instruments and their pages."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownInstrument(OmnistudyError):
    """An instrument that is neither a file nor a name in a configuration folder."""

    def __init__(self, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"no survey '{given}': there is no such file, and the surveys are "
            f"{', '.join(allowed)}{nearest(given, allowed)}"
        )


class BrokenInstrument(OmnistudyError):
    """An instrument's page that does not say an instrument; one sentence a fault."""

    def __init__(self, page: Path, faults: Sequence[str]) -> None:
        super().__init__("\n".join(faults))
        self.page = page
        self.faults = tuple(faults)


class AnswersDoNotFit(OmnistudyError):
    """Answers that the instrument's questions do not allow."""

    def __init__(self, instrument: str, faults: Sequence[str]) -> None:
        super().__init__(
            f"the answers do not fit survey '{instrument}': {'; '.join(faults)}: ask it again"
        )
        self.faults = tuple(faults)
