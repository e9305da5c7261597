"""What the pages of a session answer to it: stop, how late the picture was, what was asked."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from omnistudy.channel import LatestValue
from omnistudy.registry import Model
from omnistudy.survey import Answer as ItemAnswer

MOST_ITEMS = 100
"""Answers that one page may give."""


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


class Said(Model):
    """What the person said to a page between trials; which parts count depends on the page."""

    to: str
    """Mark of the page."""
    stopped: bool = False
    """Whether the stop button was pressed there."""
    agreed: bool = False
    ticked: Annotated[tuple[str, ...], Field(max_length=MOST_ITEMS)] = ()
    given: Annotated[tuple[ItemAnswer, ...], Field(max_length=MOST_ITEMS)] = ()


class Answer(Model):
    """The latest of what the server knows from its pages."""

    stop: int | None = None
    """Number of the trial that is to end."""
    lag: Lag | None = None
    """Of the participant's screen."""
    said: Said | None = None
    """By the participant."""

    @classmethod
    def latest(cls, source: LatestValue) -> Answer:
        """Read the latest answer; an empty one before the first."""
        found = source.read()
        return cls.model_validate_json(found.data) if found else cls()
