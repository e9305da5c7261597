"""What the pages of a live trial answer to the session: stop, and how late its picture was."""

from __future__ import annotations

from omnistudy.channel import LatestValue
from omnistudy.registry import Model


class Lag(Model):
    """How long it took from a state of the simulation to the frame that shows it, ms.

    It begins when the state is written and ends with the page's first animation frame after the one
    it was drawn in: the picture has then been handed to the display. The way back to the server is
    not in it.

    frames : drawn so far. clock_ms : how far off every number may be, since the page knows the
    session's clock only to half of its quickest question and answer.
    """

    trial: int
    frames: int
    median_ms: float
    p99_ms: float
    clock_ms: float


class Answer(Model):
    """The latest of what the server knows from its pages."""

    stop: int | None = None
    """Number of the trial that is to end."""
    lag: Lag | None = None
    """Of the participant's screen."""

    @classmethod
    def latest(cls, source: LatestValue) -> Answer:
        """Read the latest answer; an empty one before the first."""
        found = source.read()
        return cls.model_validate_json(found.data) if found else cls()
