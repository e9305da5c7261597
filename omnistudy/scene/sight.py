"""Where the rays of a range sensor on a robot start, and where they go."""

from __future__ import annotations

from omnistudy.registry.model import Model
from omnistudy.units import Metres, Radians


class Sight(Model):
    """The rays of a sensor in the robot's frame: one from each of `origins` towards its angle.

    origins : (x, y) in m. angles : rad, counter-clockwise from straight ahead.
    height : of all rays above the floor, m. max_range : m, what is further off is not seen.
    """

    origins: tuple[tuple[Metres, Metres], ...]
    angles: tuple[Radians, ...]
    height: Metres
    max_range: Metres
