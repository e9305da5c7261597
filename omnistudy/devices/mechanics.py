"""A mass with a spring and a damper, stepped exactly while its force is held."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class HeldStep(NamedTuple):
    """q' = qq·q + qv·v + qu·u, v' = vq·q + vv·v + vu·u for a force u held over one tick."""

    qq: float
    qv: float
    qu: float
    vq: float
    vv: float
    vu: float


def held_step(mass: float, damping: float, stiffness: float, dt: float) -> HeldStep:
    """Solve m·q'' + b·q' + k·q = u over dt seconds, u constant (matrix exponential).

    mass in kg (kg·m²), damping in N·s/m (N·m·s), stiffness in N/m (N·m/rad), dt in s.
    """
    system = np.array(
        [[0.0, 1.0, 0.0], [-stiffness / mass, -damping / mass, 1.0 / mass], [0.0, 0.0, 0.0]]
    )
    halvings = max(0, int(np.ceil(np.log2(max(1e-12, np.abs(system * dt).sum(axis=1).max())))) + 4)
    small = system * (dt / 2.0**halvings)
    result, term = np.eye(3), np.eye(3)
    for order in range(1, 13):
        term = term @ small / order
        result = result + term
    for _ in range(halvings):
        result = result @ result
    return HeldStep(*(float(value) for value in result[:2].ravel()))
