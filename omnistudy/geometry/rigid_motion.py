"""Rotations and poses in space as matrices: made, inverted, compared."""

from __future__ import annotations

from math import atan2, cos, hypot, sin, sqrt

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

NEARLY_TURNED_BACK = -0.99
"""Cosine of an angle past which the axis is read from the symmetric part of a rotation."""


def rotation(axis: Floats, angle: float) -> Floats:
    """Give the rotation by an angle in rad about a unit axis (3,), as (3, 3)."""
    x, y, z = axis.tolist()
    c, s = cos(angle), sin(angle)
    t = 1.0 - c
    return np.array(
        [
            [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
        ]
    )


def rotation_vector(turned: Floats) -> Floats:
    """Give the logarithm of a rotation (3, 3): its axis times its angle, 0 to pi rad, (3,).

    At half a turn, where the axis has two signs, the one with a positive greatest part is given.
    Corrects eq. (1) of Farelo 2009, whose arc tangent of a ratio is wrong past a quarter turn.
    """
    xx, xy, xz, yx, yy, yz, zx, zy, zz = turned.ravel().tolist()
    x, y, z = 0.5 * (zy - yz), 0.5 * (xz - zx), 0.5 * (yx - xy)
    sine, cosine = sqrt(x * x + y * y + z * z), 0.5 * (xx + yy + zz - 1.0)
    angle = atan2(sine, cosine)
    if cosine < NEARLY_TURNED_BACK:
        return angle * _axis_near_half_turn(turned, cosine, np.array((x, y, z)))
    factor = angle / sine if sine > 0.0 else 1.0
    return np.array((factor * x, factor * y, factor * z))


def _axis_near_half_turn(turned: Floats, cosine: float, leaning: Floats) -> Floats:
    """Read k from k k' = (symmetric part - cos I) / (1 - cos); the sign from what is left."""
    squares = (0.5 * (turned + turned.T) - cosine * np.eye(3)) / (1.0 - cosine)
    axis = squares[:, int(np.argmax(np.diag(squares)))]
    axis = axis / np.linalg.norm(axis)
    flipped: Floats = -axis if float(axis @ leaning) < 0.0 else axis
    return flipped


def transform(turned: Floats, place: Floats) -> Floats:
    """Give the pose (4, 4) of a rotation (3, 3) and a place (3,)."""
    pose = np.eye(4)
    pose[:3, :3] = turned
    pose[:3, 3] = place
    return pose


def inverse(pose: Floats) -> Floats:
    """Give the pose (4, 4) that undoes another."""
    back = np.eye(4)
    back[:3, :3] = pose[:3, :3].T
    back[:3, 3] = -pose[:3, :3].T @ pose[:3, 3]
    return back


def pose_error(pose: Floats, wanted: Floats) -> Floats:
    """Give what leads from one pose to another, (6,): way in m, rotation vector in rad.

    Both in the axes in which the poses are given. Right for every angle, half a turn included.
    """
    error = np.empty(6)
    error[:3] = wanted[:3, 3] - pose[:3, 3]
    error[3:] = rotation_vector(wanted[:3, :3] @ pose[:3, :3].T)
    return error


def sine_error(pose: Floats, wanted: Floats) -> Floats:
    """Give the same with the sine of the angle for the angle (Luh 1980), as the thesis has it.

    Its rotation is wrong past a quarter turn and vanishes at half a turn.
    """
    error = np.empty(6)
    error[:3] = wanted[:3, 3] - pose[:3, 3]
    left = wanted[:3, :3] @ pose[:3, :3].T
    error[3:] = 0.5 * (left[2, 1] - left[1, 2])
    error[4] = 0.5 * (left[0, 2] - left[2, 0])
    error[5] = 0.5 * (left[1, 0] - left[0, 1])
    return error


def quaternion(turned: Floats) -> tuple[float, float, float, float]:
    """Give a rotation (3, 3) as a unit quaternion (x, y, z, w) with w not negative."""
    vector = rotation_vector(turned)
    angle = hypot(*vector.tolist())
    factor = sin(0.5 * angle) / angle if angle > 0.0 else 0.5
    x, y, z = (factor * vector).tolist()
    return x, y, z, cos(0.5 * angle)
