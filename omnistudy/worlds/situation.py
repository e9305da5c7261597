"""What a person at the stick is told and shown of the task at one instant."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.worlds.route import Leg


class Situation(NamedTuple):
    """The leg being driven (None: nothing to drive to) and whether "drive away" is on screen."""

    leg: Leg | None = None
    drive_away: bool = False
