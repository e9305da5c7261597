"""What every controller is: device state and sensing in, plant command out."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, NamedTuple

from omnistudy.devices import DeviceState
from omnistudy.geometry import Matrix3, Scan
from omnistudy.registry import KindModel


class Control(NamedTuple):
    """One decision of a controller.

    intent : what the stick asks for; all zero is no command. For a robot on the floor a
        PlanarTwist, which laws damp; for others as many numbers as the device has axes.
    command : what the plant is told (a PlanarTwist for a mobile base, joint rates for an arm).
    state : the controller's own state, given back to it at the next step.
    """

    intent: tuple[float, ...]
    command: Any
    state: Any = None


class Controller(KindModel, ABC):
    """A controller: pure, its own state passed in and out."""

    @property
    @abstractmethod
    def twist_per_stick(self) -> Matrix3:
        """3x3 d(intent)/d(stick) inside the working range, (m/s)/m and (rad/s)/rad."""

    def initial_state(self) -> Any:
        """Give the state before the first step; None for a controller without one."""
        return None

    @abstractmethod
    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Decide for one physics step of `dt` seconds."""
