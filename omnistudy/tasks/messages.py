"""The sentences that a participant reads during a task."""

from __future__ import annotations

from omnistudy.registry import Model


class Screen(Model):
    """What stands on a participant's screen round the task's own sentences (ours)."""

    waiting: str
    """Between two trials."""
    next_target: str
    """Beside the colour of the block to be reached next."""
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
