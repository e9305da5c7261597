"""How long each law takes for one field beside a wall."""

from __future__ import annotations

import time

import numpy as np

from omnistudy.geometry import PlanarTwist, Scan
from omnistudy.laws import Sensed
from omnistudy.registry import kinds, load_kind

CALLS = 2000
RAYS = 128
WALL_AHEAD = 0.4
REACH = 0.6


def field_microseconds() -> dict[str, float]:
    """Give us for one field, by kind, with a wall 0.4 m ahead inside the boundary layer."""
    per_stick = load_kind("controllers", "rate")().twist_per_stick
    sensed = Sensed(wall_ahead(), PlanarTwist(0.2, 0.1, 0.3), per_stick)
    return {kind: _microseconds(kind, sensed) for kind in kinds("laws")}


def wall_ahead() -> Scan:
    """Give the scan of an endless wall across the robot's way."""
    angles = -np.pi + np.arange(RAYS) * (2.0 * np.pi / RAYS)
    ahead = np.maximum(np.cos(angles), 1e-9)
    return Scan(angles, np.minimum(WALL_AHEAD / ahead, REACH), REACH)


def _microseconds(kind: str, sensed: Sensed) -> float:
    law = load_kind("laws", kind)()
    law.field(sensed)
    began = time.perf_counter()
    for _ in range(CALLS):
        law.field(sensed)
    return (time.perf_counter() - began) / CALLS * 1e6
