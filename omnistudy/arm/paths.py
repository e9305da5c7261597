"""Where a hand is led, as values: a straight line, an arc about a hinge."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from omnistudy.geometry.rigid_motion import rotation, rotation_vector, transform

Floats = NDArray[np.float64]


class Path(ABC):
    """Poses (4, 4) in ground axes, from share 0 to share 1."""

    @property
    @abstractmethod
    def length(self) -> float:
        """Way of the hand, m."""

    @property
    @abstractmethod
    def angle(self) -> float:
        """How far the hand turns on the way, rad, not negative."""

    @abstractmethod
    def pose(self, share: float) -> Floats:
        """Give the hand's pose (4, 4)."""

    @abstractmethod
    def tangent(self, share: float) -> Floats:
        """Give the hand's twist per share, (6,): m and rad, in ground axes."""

    @property
    def leads(self) -> Floats:
        """The straight way on the floor from beginning to end, (2,), m."""
        way: Floats = self.pose(1.0)[:2, 3] - self.pose(0.0)[:2, 3]
        return way


@dataclass(frozen=True, eq=False)
class LinePath(Path):
    """Straight from one pose to another, turning evenly about one axis on the way.

    The axis is the logarithm of the whole turn, so that half a turn is no exception.
    """

    start: Floats
    goal: Floats

    @cached_property
    def _way(self) -> Floats:
        way: Floats = self.goal[:3, 3] - self.start[:3, 3]
        return way

    @cached_property
    def _turn(self) -> Floats:
        """Rotation vector in axes of the start, (3,), rad."""
        return rotation_vector(self.start[:3, :3].T @ self.goal[:3, :3])

    @cached_property
    def _axis(self) -> Floats:
        return self._turn / self.angle if self.angle > 0.0 else np.array((1.0, 0.0, 0.0))

    @cached_property
    def length(self) -> float:
        """Way of the hand, m."""
        return float(np.linalg.norm(self._way))

    @cached_property
    def angle(self) -> float:
        """How far the hand turns, rad."""
        return float(np.linalg.norm(self._turn))

    def pose(self, share: float) -> Floats:
        """Give the hand's pose (4, 4)."""
        turned = self.start[:3, :3] @ rotation(self._axis, self.angle * share)
        return transform(turned, self.start[:3, 3] + share * self._way)

    def tangent(self, share: float) -> Floats:
        """Give the hand's twist per share: the same all the way."""
        return np.concatenate((self._way, self.start[:3, :3] @ self._turn))


@dataclass(frozen=True, eq=False)
class ArcPath(Path):
    """Round a hinge, as the handle of a door goes.

    hinge : (3,) a point of the hinge's axis, m. axis : (3,) of unit length. turn : rad, right
    handed about the axis. following : whether the hand turns with the door.
    """

    start: Floats
    hinge: Floats
    axis: Floats
    turn: float
    following: bool

    @cached_property
    def radius(self) -> float:
        """Distance of the hand from the hinge's axis, m."""
        arm = self.start[:3, 3] - self.hinge
        return float(np.linalg.norm(arm - (arm @ self.axis) * self.axis))

    @property
    def length(self) -> float:
        """Way of the hand, m."""
        return self.radius * abs(self.turn)

    @property
    def angle(self) -> float:
        """How far the hand turns, rad."""
        return abs(self.turn) if self.following else 0.0

    def pose(self, share: float) -> Floats:
        """Give the hand's pose (4, 4)."""
        swing = rotation(self.axis, self.turn * share)
        place = self.hinge + swing @ (self.start[:3, 3] - self.hinge)
        turned = swing @ self.start[:3, :3] if self.following else self.start[:3, :3]
        return transform(turned, place)

    def tangent(self, share: float) -> Floats:
        """Give the hand's twist per share."""
        about = self.turn * self.axis
        lever = self.pose(share)[:3, 3] - self.hinge
        turning = about if self.following else np.zeros(3)
        return np.concatenate((np.cross(about, lever), turning))
