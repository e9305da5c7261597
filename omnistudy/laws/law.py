"""What every feedback law is: a frozen parameter model with one pure method."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import NamedTuple

from omnistudy.geometry import ForceField, Matrix3, PlanarTwist, PlanarWrench, Scan, Vector3
from omnistudy.registry import KindModel


class Sensed(NamedTuple):
    """All that a law may know.

    scan : ranges around the robot.
    twist : what the stick asks for, before the compliance-centre shift (spec 4.3), m/s, rad/s.
    twist_per_stick : 3x3, d(twist)/d(stick), (m/s)/m, (rad/s)/rad.
    stick, stick_rate : position (m, m, rad) and rate of the stick.
    """

    scan: Scan
    twist: PlanarTwist
    twist_per_stick: Matrix3
    stick: Vector3 = (0.0, 0.0, 0.0)
    stick_rate: Vector3 = (0.0, 0.0, 0.0)


class Law(KindModel, ABC):
    """A feedback law: what is sensed in, a local force field out; no state, no clipping."""

    @abstractmethod
    def field(self, sensed: Sensed) -> ForceField:
        """Give the field to be rendered until the next scan."""


class WrenchLaw(Law):
    """A law that is affine in the twist, so its author writes only `wrench`."""

    @abstractmethod
    def wrench(self, scan: Scan, twist: PlanarTwist) -> PlanarWrench:
        """Give the wrench on the hand in N, N, N·m, unclipped."""

    def field(self, sensed: Sensed) -> ForceField:
        """Give the wrench and, as stiffness, -(dF/dtwist)·twist_per_stick."""
