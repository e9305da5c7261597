"""What a range sensor that rides on a chassis can do."""

from __future__ import annotations

from abc import ABC, abstractmethod

from omnistudy.channel import Channel
from omnistudy.geometry import PlanarTwist, Scan


class SensorOnChassis(ABC):
    """A range sensor during one trial, with whatever it remembers from scan to scan."""

    channels: tuple[Channel, ...] = ()
    """What is recorded of it."""

    @abstractmethod
    def scan(self, step: int, twist: PlanarTwist) -> Scan:
        """Look from the present pose.

        step : physics steps since the trial opened.
        twist : of the robot, as its own encoders tell it.
        """

    def values(self) -> tuple[float, ...]:
        """Give the present value of each channel."""
        return ()
