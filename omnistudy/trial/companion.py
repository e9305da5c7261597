"""What goes along with a live trial: it keeps the pace, looks on, and may end the trial."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import NamedTuple

from omnistudy.channel import Channel, Event
from omnistudy.geometry import PlanarWrench, Scan
from omnistudy.worlds import Situation


class Glimpse(NamedTuple):
    """A trial at one instant, for those who look on; nothing of it may be changed.

    plant, device : present values, as the channels given to `begin` name them.
    wrench : of the law, unclipped. scan : the latest one, None without a sensor.
    events : all that happened so far.
    """

    t: float
    plant: tuple[float, ...]
    device: tuple[float, ...]
    wrench: PlanarWrench
    scan: Scan | None
    situation: Situation
    collisions: int
    events: Sequence[Event]


class Companion(ABC):
    """Called by the loop between steps; whatever it does, the trial's samples stay the same."""

    glimpse_hz = 60
    """How often it is shown the trial."""

    @abstractmethod
    def begin(self, plant: tuple[Channel, ...], axes: tuple[Channel, ...]) -> None:
        """Hear that a trial opens, and what its glimpses will hold."""

    @abstractmethod
    def goes_on(self, t: float) -> bool:
        """Come back when it is time for the step that begins at t s; False ends the trial."""

    @abstractmethod
    def see(self, glimpse: Glimpse) -> None:
        """Look at the trial, the last time when it has ended."""

    @abstractmethod
    def end(self, status: str) -> None:
        """Hear how the trial ended."""
