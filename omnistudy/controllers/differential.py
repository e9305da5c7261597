"""What a robot on two driven wheels makes of a twist that it cannot reach."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from omnistudy.controllers.controller import Control, Controller
from omnistudy.devices import DeviceState
from omnistudy.geometry import Matrix3, PlanarTwist, Scan
from omnistudy.units import Metres, MetresPerSecond, Positive


class DifferentialController(Controller):
    """Clips a commanded twist as a TurtleBot3 Burger's firmware and motors do.

    Forward speed and turning rate are clipped first, then each wheel: at full speed a turn slows
    the robot down, and turns less than asked. Numbers: ROBOTIS OpenCR firmware, turtlebot3_burger.h
    (wheel radius 33 mm, 61 rpm, wheel separation 160 mm).
    """

    kind: Literal["differential"] = "differential"
    top_wheel_speed: Annotated[MetresPerSecond, Positive] = 0.2108
    """Of a wheel's rim, either way: 0.033 m · 61 rpm."""
    track: Annotated[Metres, Positive] = 0.160
    """From wheel to wheel."""

    @property
    def twist_per_stick(self) -> Matrix3:
        """Below the limits the position is the twist; there is no sideways axis."""
        return ((1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Take the device's first and last number as m/s and rad/s; the robot cannot go aside."""
        top, half = self.top_wheel_speed, 0.5 * self.track
        forward = max(-top, min(top, device.position[0]))
        turn = half * max(-top / half, min(top / half, device.position[2]))
        left = max(-top, min(top, forward - turn))
        right = max(-top, min(top, forward + turn))
        command = PlanarTwist(0.5 * (left + right), 0.0, (right - left) / self.track)
        return Control(command, command)
