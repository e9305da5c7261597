"""What a controller of an arm tells of one step besides its command."""

from __future__ import annotations

from typing import NamedTuple


class StepReport(NamedTuple):
    """Measures of one step.

    manipulability : sqrt det(J W^-1 J'), rows in m and rad, drive counted in wheel radians.
    damping : k of eq. (13), in the units of the damping that is used.
    hits : what held the motion back, such as "speed 3", "limit 6" or "zone shoulder".
    progress : share of what was asked for that was done; below 1 only for a controller that slows
        hand and chair together instead of leaving the path.
    """

    manipulability: float = 0.0
    damping: float = 0.0
    hits: tuple[str, ...] = ()
    progress: float = 1.0
