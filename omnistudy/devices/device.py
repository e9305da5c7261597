"""What every device can do: be held by a hand, render a force field, tell where it is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import Channel
from omnistudy.geometry import ForceField
from omnistudy.registry import KindModel


class DeviceState(NamedTuple):
    """Where the device is, as its own sensors tell it.

    position : one number an axis, SI (the 3-DOF stick: m, m, rad).
    rate : the same per second.
    """

    position: tuple[float, ...]
    rate: tuple[float, ...]


class Hand(NamedTuple):
    """A hand on the device: one spring, damper and mass an axis, pulled to `reference`.

    reference : where the hand wants the device, in the device's own coordinates.
    stiffness, damping, mass : per axis, SI. A hand with infinite stiffness prescribes the position.
    """

    reference: tuple[float, ...]
    stiffness: tuple[float, ...]
    damping: tuple[float, ...]
    mass: tuple[float, ...]


class Device(KindModel, ABC):
    """Parameters of a device; `connect` makes the running one."""

    @abstractmethod
    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the device at rest in its centre; it is advanced `physics_hz` times a second."""

    def own_force(
        self, position: NDArray[np.float64], rate: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Give what its motors push without any field, such as centring; none unless overridden.

        position, rate and result : (n, axes), SI.
        """
        return np.zeros_like(position)


class RunningDevice(ABC):
    """A device during one trial."""

    axes: tuple[Channel, ...]
    """Name, unit, meaning and resolution of each position axis; a rate has the same resolution."""

    channels: tuple[Channel, ...] = ()
    """What else is worth recording, besides the axes; see `values`."""

    def values(self) -> tuple[float, ...]:
        """Give the present value of each channel."""
        return ()

    @abstractmethod
    def render(self, field: ForceField) -> None:
        """Take a new force field; it holds until the next or until it is stale."""

    @abstractmethod
    def advance(self, hand: Hand) -> DeviceState:
        """Let one physics step pass with a hand on the device; give what the sensors then say."""
