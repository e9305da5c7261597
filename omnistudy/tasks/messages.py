"""The sentences that a participant reads during a task."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from omnistudy.registry import Model
from omnistudy.tasks.pages import Pages


class Screen(Model):
    """What stands on a participant's screen round the task's own sentences (ours)."""

    waiting: str
    """Between two trials."""
    next_target: str
    """Beside the colour and the name of the block to be reached next."""
    stop: str
    """On the button that ends the trial."""
    stopped: str
    """After that."""
    connection_lost: str
    """When the picture stands still because nothing arrives."""
    no_picture: str
    """When the browser cannot draw the world."""
    scene: str
    """What the picture shows, for those who cannot see it."""


class Called(Model):
    """What a block of a world is called, so that nobody needs to tell colours apart."""

    name: Annotated[str, Field(min_length=1)]
    """In the world's page."""
    word: Annotated[str, Field(min_length=1)]
    """On the screen."""


def _listed(given: Any) -> Any:
    """Read a mapping from a block's name to its word."""
    if not isinstance(given, dict):
        return given
    return [{"name": name, "word": word} for name, word in given.items()]


class Messages(Model):
    """One language's sentences; `{number}` is filled in (Tyagi 2017, App. B)."""

    language: str
    drive_away: str
    """On screen from a collision until the robot is clear; `{number}` counts from 1."""
    good_job: str
    """For 4 s at a block."""
    next_block: str
    game_over: str
    round_complete: str
    """At the finish; `{number}` is the total of collisions."""
    screen: Screen | None = None
    """None: only where nobody looks at a screen."""
    blocks: Annotated[tuple[Called, ...], BeforeValidator(_listed)] = ()
    """A mapping from the name of a block in the world to the word for it."""
    pages: Pages | None = None
    """What is read between trials; None: only where nobody looks at a screen."""
