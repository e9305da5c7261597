"""Controllers that are led on hand and chair at once, and slow both rather than leave the way."""

from __future__ import annotations

from abc import ABC, abstractmethod

from omnistudy.controllers.controller import Controller


class LedController(Controller, ABC):
    """Takes the chair's rates and a posture besides the hand's twist.

    It does one share of all that is asked for, and says which in its report's `progress`: whoever
    leads it goes on along the way by that much. So its tasks are planned before they move.
    """

    @property
    @abstractmethod
    def turns_hand(self) -> bool:
        """Whether it brings the hand's rotation to what is asked for, or only its place."""
