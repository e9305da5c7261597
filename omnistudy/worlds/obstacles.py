"""How far points of the floor are from what a robot cannot pass."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, inf, sin

import numpy as np
from numpy.typing import NDArray

from omnistudy.scene import Body, Box

Points = NDArray[np.float64]

PAIRS_AT_ONCE = 200_000
"""Pairs of a point and a body that are measured at once: some 20 MB."""


@dataclass(frozen=True, slots=True, eq=False)
class Obstacles:
    """The plans of m bodies: rectangles, and circles as points with a radius.

    names : what each is called, or what it is part of.
    centres : (m, 2) m. along : (m, 2) unit vectors of the rectangles' first axis.
    halves : (m, 2) m, half sides, zero for circles. radii : (m,) m, zero for rectangles.
    """

    names: tuple[str, ...]
    centres: Points
    along: Points
    halves: Points
    radii: NDArray[np.float64]

    def towards(self, points: Points) -> tuple[Points, NDArray[np.float64]]:
        """Give the vectors (n, m, 2) from each point to each body's nearest inner point.

        The second value holds the distances (n, m) in m to the bodies' surfaces; zero and below
        is inside.
        """
        offset = points[:, None, :] - self.centres[None]
        across = np.stack((-self.along[:, 1], self.along[:, 0]), axis=1)
        first = np.einsum("nmk,mk->nm", offset, self.along)
        second = np.einsum("nmk,mk->nm", offset, across)
        back_first = np.clip(first, -self.halves[:, 0], self.halves[:, 0]) - first
        back_second = np.clip(second, -self.halves[:, 1], self.halves[:, 1]) - second
        vectors = back_first[..., None] * self.along + back_second[..., None] * across
        return vectors, np.hypot(back_first, back_second) - self.radii

    def distances(self, points: Points) -> NDArray[np.float64]:
        """Give the distances (n, m) in m from each point to each body's surface."""
        return np.concatenate([self.towards(piece)[1] for piece in self.pieces(points)])

    def pieces(self, points: Points) -> list[Points]:
        """Cut points (n, 2) into pieces so short that `towards` needs little memory."""
        return np.array_split(points, len(points) * len(self.names) // PAIRS_AT_ONCE + 1)

    def near(self, points: Points, radius: float) -> Obstacles:
        """Give those bodies alone that may be nearer than `radius` m to one of the points."""
        reach = radius + np.hypot(*self.halves.T) + self.radii
        low, high = points.min(axis=0), points.max(axis=0)
        beside = np.maximum(low - self.centres, self.centres - high).max(axis=1, initial=-inf)
        chosen = np.flatnonzero(beside <= reach)
        return Obstacles(
            tuple(self.names[index] for index in chosen),
            self.centres[chosen],
            self.along[chosen],
            self.halves[chosen],
            self.radii[chosen],
        )


def obstacles(bodies: Iterable[Body]) -> Obstacles:
    """Take the plans of the bodies that block the way: solid ones, doors excepted."""
    blocking = [body for body in bodies if body.blocks]
    shapes = [body.geometry for body in blocking]
    return Obstacles(
        names=tuple(body.part_of or body.name for body in blocking),
        centres=np.array([(body.x, body.y) for body in blocking]).reshape(-1, 2),
        along=np.array([(cos(body.yaw), sin(body.yaw)) for body in blocking]).reshape(-1, 2),
        halves=np.array(
            [(s.x / 2, s.y / 2) if isinstance(s, Box) else (0.0, 0.0) for s in shapes]
        ).reshape(-1, 2),
        radii=np.array([0.0 if isinstance(s, Box) else s.radius for s in shapes]),
    )
