"""The sentences that a participant reads during a task."""

from __future__ import annotations

from omnistudy.registry import Model


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
