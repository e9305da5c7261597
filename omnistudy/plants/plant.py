"""What every plant can do: be built in a scene, take a command, step, be seen."""

from __future__ import annotations

from abc import ABC, abstractmethod
from math import sqrt
from typing import Any

from omnistudy.channel import Channel
from omnistudy.geometry import PlanarPose, Scan
from omnistudy.registry import KindModel
from omnistudy.scene import Box, Link, Scene, Sight

PLAIN_HEIGHT = 0.2
"""Of the block in m that stands for a robot of unknown looks."""


class Plant(KindModel, ABC):
    """Parameters of a robot; `build` makes the running one."""

    @abstractmethod
    def build(self, scene: Scene, start: PlanarPose, physics_hz: int, seed: str) -> RunningPlant:
        """Put the robot into the scene; raises StartsInWall when it does not fit there.

        seed : of the trial, behind every draw of the robot, such as the noise of its sensors.
        """

    @property
    @abstractmethod
    def width(self) -> float:
        """The widest the robot is across its way, in m, for checks of passages."""

    @property
    def circumradius(self) -> float:
        """Radius in m of the circle swept by a turn on the spot; that of a square unless given."""
        return self.width / sqrt(2.0)

    @property
    def footprint(self) -> tuple[float, float]:
        """Half length and half width in m of its outline on the floor; a square unless given."""
        return 0.5 * self.width, 0.5 * self.width

    @property
    def links(self) -> tuple[Link, ...]:
        """What is seen of it, parents before children; one plain block unless given."""
        block = Box(x=self.width, y=self.width, z=PLAIN_HEIGHT)
        return (Link(name="base", geometry=block, z=0.5 * PLAIN_HEIGHT),)

    @property
    def sight(self) -> Sight | None:
        """The rays of its range sensor; None without one."""
        return None


class RunningPlant(ABC):
    """A robot during one trial.

    `state` has at least `contacts: Contacts`; a robot on the floor gives a PlanarState.
    Channels named like a column of the `sample` table (x, y, theta, vx, vy, omega) go there, all
    others to a stream.
    """

    channels: tuple[Channel, ...]

    @property
    @abstractmethod
    def state(self) -> Any:
        """What is seen of the robot now."""

    @property
    @abstractmethod
    def travelled(self) -> float:
        """Length in m of the way gone so far, summed over physics steps."""

    @abstractmethod
    def values(self) -> tuple[float, ...]:
        """Give the present value of each channel."""

    @abstractmethod
    def command(self, command: Any) -> None:
        """Take the command for the coming step."""

    @abstractmethod
    def step(self) -> None:
        """Let one physics step pass."""

    def scan(self) -> Scan | None:
        """Give a turn of the range sensor, or None when the robot has none."""
        return None

    @abstractmethod
    def close(self) -> None:
        """Let go of the physics."""
