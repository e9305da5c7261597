"""Stick position commands velocity, as the thesis's firmware does it."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Any, Literal

from pydantic import Field

from omnistudy.controllers.controller import Control, Controller
from omnistudy.devices import DeviceState
from omnistudy.devices.stick_scale import StickScale
from omnistudy.geometry import Matrix3, PlanarTwist, Scan
from omnistudy.units import Metres, Positive, Ratio


class RateController(Controller):
    """Counts, limits, dead zones and gains of the firmware (Tyagi 2017, App. B)."""

    kind: Literal["rate"] = "rate"
    scale: StickScale = StickScale()
    counts_limit: Annotated[Ratio, Positive] = 300.0
    """x and y counts are clipped to this, either way."""
    counts_limit_theta: Annotated[Ratio, Positive] = 1440.0
    per_count: Annotated[Ratio, Positive] = 0.003
    """x, y command per count, (m/s)/count before the gain."""
    per_count_theta: Annotated[Ratio, Positive] = 0.012
    """theta command per count, (rad/s)/count before the gain."""
    limit_theta: Annotated[Ratio, Positive] = 3.0
    """theta command is clipped to this, rad/s before the gain."""
    dead_zone: Annotated[Ratio, Field(ge=0)] = 0.2
    """x, y commands smaller than this become zero (the value jumps, it is not shifted)."""
    dead_zone_theta: Annotated[Ratio, Field(ge=0)] = 0.5
    gain: Annotated[Ratio, Positive] = 0.4
    """From command to the robot's twist: 0.36 m/s and 1.2 rad/s at most."""
    compliance_centre: Metres = 0.0
    """Ahead of the robot's centre; the stick's rotation turns the robot about it."""

    @cached_property
    def _numbers(self) -> tuple[float, ...]:
        return (
            1.0 / self.scale.metres_per_count,
            1.0 / self.scale.radians_per_count,
            self.counts_limit,
            self.counts_limit_theta,
            self.per_count,
            self.per_count_theta,
            self.limit_theta,
            self.dead_zone,
            self.dead_zone_theta,
            self.gain,
            self.compliance_centre,
        )

    @property
    def twist_per_stick(self) -> Matrix3:
        """3x3 d(intent)/d(stick) between dead zone and limit, (m/s)/m and (rad/s)/rad."""
        linear = self.per_count * self.gain / self.scale.metres_per_count
        angular = self.per_count_theta * self.gain / self.scale.radians_per_count
        return ((linear, 0.0, 0.0), (0.0, linear, 0.0), (0.0, 0.0, angular))

    def intent(self, position: tuple[float, ...]) -> PlanarTwist:
        """Give the twist that a stick position (m, m, rad) asks for."""
        per_metre, per_radian, limit, limit_theta, a, b, top, dead, dead_theta, gain, _ = (
            self._numbers
        )
        x, y, theta = position
        vx = a * max(-limit, min(limit, x * per_metre))
        vy = a * max(-limit, min(limit, y * per_metre))
        omega = b * max(-limit_theta, min(limit_theta, theta * per_radian))
        omega = max(-top, min(top, omega))
        return PlanarTwist(
            vx * gain if abs(vx) >= dead else 0.0,
            vy * gain if abs(vy) >= dead else 0.0,
            omega * gain if abs(omega) >= dead_theta else 0.0,
        )

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Turn about the compliance centre: vy = stick's vy - omega·c."""
        twist = self.intent(device.position)
        vx, vy, omega = twist
        return Control(twist, PlanarTwist(vx, vy - omega * self._numbers[-1], omega))
