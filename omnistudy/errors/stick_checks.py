"""What the checks before force find."""

from __future__ import annotations

from collections.abc import Sequence

from omnistudy.errors.base import OmnistudyError


class ChecksFailed(OmnistudyError):
    """Checks before force that did not pass."""

    def __init__(self, failed: Sequence[str]) -> None:
        super().__init__(
            f"the stick gets no force: {'; '.join(failed)}; mend it (docs/safety.md), check again"
        )


class ForceGone(OmnistudyError):
    """A stick that took its force away while it was checked."""

    def __init__(self, state: str, faults: str) -> None:
        super().__init__(
            f"the stick took its force away (state {state}; {faults}): hold the dead-man's switch, "
            "keep the handle free, and check again"
        )


class NobodyHeld(OmnistudyError):
    """A dead-man's switch that nobody held."""

    def __init__(self, seconds: float) -> None:
        super().__init__(
            f"nobody held the dead-man's switch within {seconds:g} s: begin again when somebody "
            "holds the handle"
        )
