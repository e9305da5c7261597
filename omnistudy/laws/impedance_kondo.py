"""The haptic stick that looks only where the wheelchair goes."""

from __future__ import annotations

from math import hypot
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from omnistudy.laws.boundary import Penetrations
from omnistudy.laws.impedance import ImpedanceLaw
from omnistudy.laws.law import Sensed
from omnistudy.units import Metres, Positive


class ImpedanceKondoLaw(ImpedanceLaw):
    """The stick grows stiffer the nearer an obstacle is on the robot's way.

    tau = D·q' + K·q against the hand, K from eq. 1.4 (Kondo et al. 2008 after Tyagi 2017, sec. 1.5,
    eq. 1.5). Only what lies in the recognition area counts: the band between the two lines that are
    parallel to the motion and touch the ellipse round the robot, on the side that the robot moves
    to (the side is ours: the text leaves open whether what lies behind counts). Motion is what the
    stick asks for in x and y; without any there is no area, and the field is that without obstacle.
    """

    kind: Literal["impedance_kondo"] = "impedance_kondo"

    half_length: Annotated[Metres, Positive] = 0.41
    """Of the ellipse, front to back. Ours: through the corners of the published robot, 0.29·√2."""

    half_width: Annotated[Metres, Positive] = 0.27
    """Of the ellipse, side to side. Ours: through the corners of the published robot, 0.19·√2."""

    def counting(self, inside: Penetrations, sensed: Sensed) -> NDArray[np.bool_]:
        """Count what lies in the recognition area."""
        vx, vy, _ = sensed.twist
        speed = hypot(vx, vy)
        if speed == 0.0:
            return np.zeros(inside.rays.shape, np.bool_)
        x, y = sensed.scan.points()[inside.rays].T
        ahead, aside = (vx * x + vy * y) / speed, (vx * y - vy * x) / speed
        touching = hypot(self.half_length * vy, self.half_width * vx) / speed
        on_the_way: NDArray[np.bool_] = (ahead > 0.0) & (np.abs(aside) <= touching)
        return on_the_way

    def damped(self, stiffness: float) -> float:
        """Give D, the same everywhere."""
        return self.damping
