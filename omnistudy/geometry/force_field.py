"""The local force field that a law hands to a device."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.geometry.planar import PlanarWrench

Vector3 = tuple[float, float, float]
Matrix3 = tuple[Vector3, Vector3, Vector3]

ZERO_MATRIX: Matrix3 = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


class ForceField(NamedTuple):
    """F(q, q') = wrench - stiffness·(q - about) - damping·q', in stick coordinates.

    wrench : N, N, N·m at q = about.
    about : stick position (m, m, rad) at which `wrench` holds.
    stiffness, damping : 3x3, rows (x, y, theta); N/m and N·s/m, torque rows N·m per m or rad.
    valid_for : s, counted by the device from arrival; a stale field fades to zero.
    """

    wrench: PlanarWrench
    about: Vector3 = (0.0, 0.0, 0.0)
    stiffness: Matrix3 = ZERO_MATRIX
    damping: Matrix3 = ZERO_MATRIX
    valid_for: float = 0.1


NO_FORCE = ForceField(PlanarWrench(0.0, 0.0, 0.0))
