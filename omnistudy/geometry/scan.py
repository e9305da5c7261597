"""One turn of a range sensor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Scan:
    """Ranges seen around the robot at one instant.

    angles : (n,) rad, robot frame, counter-clockwise from straight ahead.
    ranges : (n,) m from the robot's centre; a ray that met nothing holds `max_range`.
    max_range : m; a range at or beyond it is no detection.
    """

    angles: NDArray[np.float64]
    ranges: NDArray[np.float64]
    max_range: float

    def mirrored(self) -> Scan:
        """Give the scan of the scene reflected left to right."""
        return Scan(-self.angles, self.ranges, self.max_range)
