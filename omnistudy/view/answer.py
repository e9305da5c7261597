"""What the pages of a live trial answer to the session: stop, and how late its picture was."""

from __future__ import annotations

from omnistudy.channel import LatestValue
from omnistudy.registry import Model


class Lag(Model):
    """From a state of the simulation to the word back that its frame was drawn, ms.

    frames : drawn so far.
    """

    trial: int
    frames: int
    median_ms: float
    p99_ms: float


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
