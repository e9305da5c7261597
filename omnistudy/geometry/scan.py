"""One turn of a range sensor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Scan:
    """Ranges seen around the robot at one instant.

    angles : (n,) rad, robot frame, counter-clockwise from straight ahead.
    ranges : (n,) m from where the ray starts; a ray that met nothing holds `max_range`.
    max_range : m; a range at or beyond it is no detection.
    origins : (n, 2) m, robot frame, where each ray starts; None for the robot's centre.
    rates : (n,) m/s, how fast each range grows, from a sensor that tells it; None from others.
    """

    angles: NDArray[np.float64]
    ranges: NDArray[np.float64]
    max_range: float
    origins: NDArray[np.float64] | None = None
    rates: NDArray[np.float64] | None = None

    def points(self) -> NDArray[np.float64]:
        """Give where each ray ends, (n, 2) m, robot frame."""
        towards = np.stack((np.cos(self.angles), np.sin(self.angles)), axis=1)
        along: NDArray[np.float64] = self.ranges[:, np.newaxis] * towards
        return along if self.origins is None else self.origins + along

    def mirrored(self) -> Scan:
        """Give the scan of the scene reflected left to right."""
        origins = None if self.origins is None else self.origins * (1.0, -1.0)
        return Scan(-self.angles, self.ranges, self.max_range, origins, self.rates)
