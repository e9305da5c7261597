"""How far a robot is from the nearest wall."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf

import numpy as np
from numpy.typing import NDArray

from omnistudy.scene import Body, Box

Floats = NDArray[np.float64]


def clearance(
    times: Floats, poses: Floats, footprint: tuple[float, float], bodies: Iterable[Body]
) -> Floats:
    """Give the gap (n,) in m between a robot's outline and the nearest wall; 0 in contact.

    times : (n,) s since the trial opened, for walls that move. poses : (n, 3) x, y in m, theta in
    rad. footprint : half length and half width of the robot in m. Infinite without walls.
    """
    nearest = np.full(len(times), inf)
    for body in bodies:
        if body.role == "wall":
            nearest = np.minimum(nearest, _gap(times, poses, footprint, body))
    return nearest


def _gap(times: Floats, poses: Floats, footprint: tuple[float, float], body: Body) -> Floats:
    """Give the gap (n,) to one body: the nearest of all corners to the other's outline."""
    places = _places(times, body)
    theta = poses[:, 2]
    shape = body.geometry
    if not isinstance(shape, Box):
        centre = _turned(places - poses[:, :2], -theta)
        return np.maximum(_outside(centre, footprint) - shape.radius, 0.0)
    halves = (0.5 * shape.x, 0.5 * shape.y)
    relative = poses[:, :2] - places
    gaps = np.full(len(times), inf)
    for sx in (-1.0, 1.0):
        for sy in (-1.0, 1.0):
            own = _turned(np.array([[sx * footprint[0], sy * footprint[1]]]), theta) + relative
            gaps = np.minimum(gaps, _outside(_turned(own, -body.yaw), halves))
            yaw = np.array([body.yaw])
            corner = _turned(np.array([[sx * halves[0], sy * halves[1]]]), yaw) - relative
            gaps = np.minimum(gaps, _outside(_turned(corner, -theta), footprint))
    return gaps


def _places(times: Floats, body: Body) -> Floats:
    if body.track is None:
        return np.array([[body.x, body.y]])
    return np.array([body.track.at(float(t))[:2] for t in times])


def _turned(points: Floats, angle: Floats | float) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    x, y = points[:, 0], points[:, 1]
    return np.stack((c * x - s * y, s * x + c * y), axis=1)


def _outside(points: Floats, halves: tuple[float, float]) -> Floats:
    """Give how far points are outside a rectangle round the origin; 0 inside."""
    beyond = np.maximum(np.abs(points) - np.array(halves), 0.0)
    distance: Floats = np.hypot(beyond[:, 0], beyond[:, 1])
    return distance
