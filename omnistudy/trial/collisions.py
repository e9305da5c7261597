"""Collisions counted twice: as the thesis's code does, and debounced."""

from __future__ import annotations

from omnistudy.channel import Event
from omnistudy.scene import Contacts

RELEASE_TIME = 0.25
"""s that the robot must stay clear before the next contact is a new collision (ours)."""


class CollisionCounter:
    """Follows the wall contacts of one trial.

    `legacy` counts rising edges of one flag for all walls; `count` opens at first
    contact and closes once the robot has been clear, by the plant's release gap, for 0.25 s.
    """

    def __init__(self, physics_hz: int) -> None:
        self._dt = 1.0 / physics_hz
        self._release_steps = round(RELEASE_TIME * physics_hz)
        self._clear_steps = 0
        self._touching = False
        self._open = False
        self._contact_steps = 0
        self.count = 0
        self.legacy = 0

    @property
    def colliding(self) -> bool:
        """Whether the last collision still goes on."""
        return self._open

    @property
    def contact_time(self) -> float:
        """Time in s in contact with any wall."""
        return self._contact_steps * self._dt

    def update(self, t: float, contacts: Contacts) -> tuple[Event, ...]:
        """Take the contacts of the step that ends at t; give what began or ended."""
        touching = bool(contacts.walls)
        if not touching and not self._open:
            self._touching = False
            return ()
        events: tuple[Event, ...] = ()
        if touching:
            self._contact_steps += 1
            self._clear_steps = 0
            if not self._touching:
                self.legacy += 1
            if not self._open:
                self._open = True
                self.count += 1
                events = (Event(t, "collision", ", ".join(contacts.walls)),)
        elif contacts.clear:
            self._clear_steps += 1
            if self._clear_steps >= self._release_steps:
                self._open = False
                events = (Event(t, "collision_end"),)
        else:
            self._clear_steps = 0
        self._touching = touching
        return events
