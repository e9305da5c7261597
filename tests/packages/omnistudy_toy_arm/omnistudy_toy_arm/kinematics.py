"""Where the hand of seven revolute joints is, and how it moves when they turn."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omnistudy.geometry import Pose

Floats = NDArray[np.float64]

AXES = ("z", "y", "z", "y", "z", "y", "z")
LINKS = (0.36, 0.0, 0.42, 0.0, 0.40, 0.0, 0.13)
"""m along each joint's own z axis, from the foot up, as in common seven-joint arms."""


def rotation(axis: str, angle: float) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    if axis == "z":
        return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def chain(joints: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Give each joint's axis and place, (7, 3) both, and the hand's place and orientation."""
    turned, place = np.eye(3), np.zeros(3)
    axes, places = [], []
    for axis, link, angle in zip(AXES, LINKS, joints, strict=True):
        axes.append(turned[:, 2 if axis == "z" else 1])
        places.append(place)
        turned = turned @ rotation(axis, float(angle))
        place = place + turned[:, 2] * link
    return np.array(axes), np.array(places), place, turned


def jacobian(joints: Floats) -> Floats:
    """(6, 7): the hand's linear and angular velocity for unit joint rates."""
    axes, places, hand, _ = chain(joints)
    return np.vstack((np.cross(axes, hand - places).T, axes.T))


def hand_pose(joints: Floats) -> Pose:
    _, _, hand, turned = chain(joints)
    w = 0.5 * np.sqrt(max(0.0, 1.0 + np.trace(turned)))
    if w > 1e-6:
        vector = np.array(
            [
                turned[2, 1] - turned[1, 2],
                turned[0, 2] - turned[2, 0],
                turned[1, 0] - turned[0, 1],
            ]
        ) / (4.0 * w)
    else:
        vector = np.sqrt(np.maximum(0.0, (np.diag(turned) + 1.0) / 2.0))
    x, y, z = (float(value) for value in hand)
    qx, qy, qz = (float(value) for value in vector)
    return Pose((x, y, z), (qx, qy, qz, float(w)))
