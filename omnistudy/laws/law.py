"""What every feedback law is: a frozen parameter model with one pure method."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import NamedTuple

from omnistudy.geometry import ForceField, Matrix3, PlanarTwist, PlanarWrench, Scan, Vector3
from omnistudy.registry import KindModel


class Sensed(NamedTuple):
    """All that a law may know.

    scan : ranges around the robot.
    twist : what the stick asks for, before the compliance-centre shift, m/s, rad/s.
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

    def twist_gradient(self, scan: Scan, twist: PlanarTwist) -> Matrix3:
        """Give dF/dtwist, 3x3, rows (fx, fy, tau), columns (vx, vy, omega), SI.

        Unit steps of twist are exact because `wrench` is affine in it; a law that is not, or that
        knows its gradient, overrides this.
        """
        here = self.wrench(scan, twist)
        vx, vy, omega = twist
        ahead = self.wrench(scan, PlanarTwist(vx + 1.0, vy, omega))
        aside = self.wrench(scan, PlanarTwist(vx, vy + 1.0, omega))
        round_about = self.wrench(scan, PlanarTwist(vx, vy, omega + 1.0))
        return (
            (ahead.fx - here.fx, aside.fx - here.fx, round_about.fx - here.fx),
            (ahead.fy - here.fy, aside.fy - here.fy, round_about.fy - here.fy),
            (ahead.tau - here.tau, aside.tau - here.tau, round_about.tau - here.tau),
        )

    def field(self, sensed: Sensed) -> ForceField:
        """Give the wrench and, as stiffness, -(dF/dtwist)·twist_per_stick."""
        gradient = self.twist_gradient(sensed.scan, sensed.twist)
        return ForceField(
            wrench=self.wrench(sensed.scan, sensed.twist),
            about=sensed.stick,
            stiffness=_negated_product(gradient, sensed.twist_per_stick),
        )


def _negated_product(left: Matrix3, right: Matrix3) -> Matrix3:
    def row(a: float, b: float, c: float) -> Vector3:
        x, y, z = right
        return (
            0.0 - (a * x[0] + b * y[0] + c * z[0]),
            0.0 - (a * x[1] + b * y[1] + c * z[1]),
            0.0 - (a * x[2] + b * y[2] + c * z[2]),
        )

    return row(*left[0]), row(*left[1]), row(*left[2])
