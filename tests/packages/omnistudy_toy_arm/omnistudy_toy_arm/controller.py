"""The device leads the hand: joint rates by a damped inverse of the Jacobian."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import numpy as np

from omnistudy.controllers import Control, Controller
from omnistudy.devices import DeviceState
from omnistudy.geometry import ZERO_MATRIX, Matrix3, Scan
from omnistudy.units import Positive, Ratio
from omnistudy_toy_arm.kinematics import jacobian

DAMPING = 0.02


class HandRates(Controller):
    """Pushes and twists of the device become the hand's velocity."""

    kind: Literal["hand_rates"] = "hand_rates"
    gain: Annotated[Ratio, Positive] = 5.0
    """Hand's velocity per deflection, 1/s."""

    @property
    def twist_per_stick(self) -> Matrix3:
        """No scan, no law: nothing to damp."""
        return ZERO_MATRIX

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        wanted = self.gain * np.array(device.position)
        rows = jacobian(np.array(plant_state.joints))
        rates = rows.T @ np.linalg.solve(rows @ rows.T + DAMPING**2 * np.eye(6), wanted)
        return Control(tuple(wanted.tolist()), rates)
