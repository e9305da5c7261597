"""The device's position is the twist: for logged commands that need no stick."""

from __future__ import annotations

from typing import Any, Literal

from omnistudy.controllers.controller import Control, Controller
from omnistudy.devices import DeviceState
from omnistudy.geometry import Matrix3, PlanarTwist, Scan


class DirectController(Controller):
    """Hands (vx, vy, omega) through unchanged; goes with the device `direct`."""

    kind: Literal["direct"] = "direct"

    @property
    def twist_per_stick(self) -> Matrix3:
        """The identity: the position is the twist."""
        return ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Take the three numbers of the device as m/s, m/s, rad/s."""
        twist = PlanarTwist(*device.position)
        return Control(twist, twist)
