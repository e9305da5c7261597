"""What impedance laws share: no push, but a stick that grows stiffer the nearer and the faster."""

from __future__ import annotations

from abc import abstractmethod
from math import hypot
from typing import Annotated

import numpy as np
from annotated_types import Ge, Gt, Le
from numpy.typing import NDArray

from omnistudy.geometry import ForceField, PlanarWrench
from omnistudy.laws.boundary import AnyBoundary, CircularBoundary, Penetrations
from omnistudy.laws.law import Law, Sensed
from omnistudy.units import (
    MetresPerSecond,
    NewtonSecondsPerMetre,
    NewtonsPerMetre,
    Positive,
    Ratio,
)


class ImpedanceLaw(Law):
    """A virtual spring to the stick's zero and a damper, in x and y; the hand feels -(K·q + D·q').

    K = K0·((v/vmax + alpha)/(r/rmax)² + 1) (Urbano et al. 2004 after Tyagi 2017, sec. 1.5,
    eq. 1.4); a subclass says which obstacle counts and what the damper does. The spring comes on
    top of the stick's own centring, the Ka of eq. 1.3.

    rmax is how far the boundary lies along the ray that sees the obstacle, so that r/rmax is 1 on
    the boundary whatever its shape, and with a circle exactly the formula's. Where no obstacle
    counts, r is rmax, as of a sensor that tells its greatest range: the field is then
    K0·(v/vmax + alpha + 1), K0·(1 + alpha) at rest, and nothing jumps as an obstacle comes in
    (ours). v is how fast the stick asks the robot to go.
    """

    boundary: AnyBoundary = CircularBoundary()
    """Where r is rmax; what lies beyond does not count."""

    stiffness: Annotated[NewtonsPerMetre, Ge(0.0)] = 20.0
    """K0. Ours: the stick's own centring is 67 N/m."""

    damping: Annotated[NewtonSecondsPerMetre, Ge(0.0)] = 2.0
    """D where the stiffness is K0. Ours: with the handle's 0.11 kg about 0.7 of critical."""

    alpha: Annotated[Ratio, Ge(0.0)] = 0.2
    """What nearness does to a robot that stands still. Ours."""

    top_speed: Annotated[MetresPerSecond, Positive] = 0.36
    """vmax: the published robot's along one axis (appendix B)."""

    nearest: Annotated[Ratio, Gt(0.0), Le(1.0)] = 0.38
    """The least r/rmax that counts, so that K stays finite. Ours: the published robot's half width
    of 0.19 m in the circle of 0.5 m, that is K0·(6.9·(v/vmax + alpha) + 1) at most."""

    @abstractmethod
    def counting(self, inside: Penetrations, sensed: Sensed) -> NDArray[np.bool_]:
        """Tell which of the obstacles inside the boundary count, (n,)."""

    @abstractmethod
    def damped(self, stiffness: float) -> float:
        """Give D in N·s/m for a K in N/m."""

    def field(self, sensed: Sensed) -> ForceField:
        """Give K and D on the diagonal, x and y alone, and the spring's force where the stick is.

        `stiffness` is K as eq. 1.4 gives it for the sensed speed and held until the next scan, not
        the slope of K(v)·q over a stick that asks for another speed as it moves.
        """
        k = self.stiffened(sensed)
        d = self.damped(k)
        x, y, _ = sensed.stick
        return ForceField(
            wrench=PlanarWrench(0.0 - k * x, 0.0 - k * y, 0.0),
            about=sensed.stick,
            stiffness=((k, 0.0, 0.0), (0.0, k, 0.0), (0.0, 0.0, 0.0)),
            damping=((d, 0.0, 0.0), (0.0, d, 0.0), (0.0, 0.0, 0.0)),
        )

    def stiffened(self, sensed: Sensed) -> float:
        """Give K of eq. 1.4 in N/m."""
        share = self._nearest(sensed)
        speed = hypot(sensed.twist.vx, sensed.twist.vy) / self.top_speed
        return self.stiffness * ((speed + self.alpha) / (share * share) + 1.0)

    def _nearest(self, sensed: Sensed) -> float:
        """Give r/rmax, 1 where no obstacle counts."""
        inside = self.boundary.penetrations(sensed.scan)
        if inside is None:
            return 1.0
        share = inside.distance / (inside.distance + inside.depth)
        share = share[self.counting(inside, sensed)]
        return max(self.nearest, float(share.min(initial=1.0)))
