"""What laws of springs and dampers share: one radial spring a ray, averaged over those that touch.

A spring touches where its ray meets something inside the boundary. Forces are means over the
touching rays alone (Tyagi 2017, eq. 4.3-4.5), so a wall that only grazes the boundary weakens what
a near post makes felt: a property of the published laws, kept.
"""

from __future__ import annotations

from abc import abstractmethod
from functools import lru_cache
from typing import Annotated, NamedTuple

import numpy as np
from annotated_types import Ge
from numpy.typing import NDArray

from omnistudy.geometry import (
    ZERO_MATRIX,
    ForceField,
    Matrix3,
    PlanarTwist,
    PlanarWrench,
    Scan,
    Vector3,
)
from omnistudy.laws import published
from omnistudy.laws.boundary import AnyBoundary, Penetrations, RectangularBoundary
from omnistudy.laws.law import Sensed, WrenchLaw
from omnistudy.registry import Model
from omnistudy.units import NewtonMetreSeconds, NewtonSecondsPerMetre, NewtonsPerMetre

Floats = NDArray[np.float64]

_NO_WRENCH = PlanarWrench(0.0, 0.0, 0.0)
_NO_DAMPING: Vector3 = (0.0, 0.0, 0.0)

_ROUND_OFF = 1e-12
"""m or m²: what summing 128 cosines leaves of a mean that symmetry makes zero."""


class Stiffness(Model):
    """Springs of the boundary layer along the robot's axes."""

    x: Annotated[NewtonsPerMetre, Ge(0.0)] = 37.5 * 100 * published.NEWTONS_PER_COUNT
    """37.5 PWM per cm of mean penetration (appendix B, gainX = 250·0.15): 198.5 N/m."""

    y: Annotated[NewtonsPerMetre, Ge(0.0)] = 24.0 * 100 * published.NEWTONS_PER_COUNT
    """24 PWM per cm of mean penetration (appendix B, gainY = 200·0.12): 127.1 N/m."""


class Damping(Model):
    """Dampers along the robot's axes, on the velocity that the stick asks for."""

    x: Annotated[NewtonSecondsPerMetre, Ge(0.0)] = 15.0 * published.NEWTONS_PER_COUNT
    """15 PWM per m/s (appendix B, dgainX = 100·0.15): 0.794 N·s/m."""

    y: Annotated[NewtonSecondsPerMetre, Ge(0.0)] = 90.0 * published.NEWTONS_PER_COUNT
    """90 PWM per m/s (appendix B, dgainY = 750·0.12): 4.765 N·s/m."""


class TurningDamping(Damping):
    """Dampers along the robot's axes and of its rotation."""

    theta: Annotated[NewtonMetreSeconds, Ge(0.0)] = 12.0 * published.NEWTON_METRES_PER_COUNT
    """12 PWM per rad/s (appendix B, dgainQ = 100·0.12): 0.207 N·m·s."""


class Touches(NamedTuple):
    """The springs that touch, all arrays (n,).

    depth : m, radial penetration.
    distance : m, from where the ray starts to what is touched.
    cos, sin : direction that the spring is resolved with.
    origins : (n, 2) m, robot frame, where each ray starts; None for the robot's centre.
    """

    depth: Floats
    distance: Floats
    cos: Floats
    sin: Floats
    origins: Floats | None = None

    @property
    def x(self) -> Floats:
        """How far ahead of the robot's centre each touched point lies, in m."""
        along = self.distance * self.cos
        return along if self.origins is None else self.origins[:, 0] + along

    @property
    def y(self) -> Floats:
        """How far to the left of the robot's centre each touched point lies, in m."""
        along = self.distance * self.sin
        return along if self.origins is None else self.origins[:, 1] + along


class SpringLaw(WrenchLaw):
    """Forces from springs and dampers along x and y; a subclass says what they turn."""

    boundary: AnyBoundary = RectangularBoundary()
    """Where the springs begin."""

    stiffness: Stiffness = Stiffness()
    """Of the springs."""

    damping: Damping = Damping()
    """Of the dampers; each joins only where the spring part of its axis is not zero."""

    as_published: bool = False
    """Do as the thesis's code does: the angle of the ray before, two decimals, far clip 0.5 m."""

    @abstractmethod
    def turning(self, touches: Touches, fx: float, fy: float) -> tuple[float, float]:
        """Give the springs' torque in N·m and the damping of rotation that joins it, N·m·s.

        fx, fy : N, what the springs push with.
        """

    def wrench(self, scan: Scan, twist: PlanarTwist) -> PlanarWrench:
        """Give springs minus dampers in N, N, N·m, unclipped."""
        return self._damped(*self._springs(scan), twist)

    def twist_gradient(self, scan: Scan, twist: PlanarTwist) -> Matrix3:
        """Give minus the active dampers on the diagonal; velocities count unrounded here."""
        x, y, theta = self._springs(scan)[1]
        return (-x, 0.0, 0.0), (0.0, -y, 0.0), (0.0, 0.0, -theta)

    def field(self, sensed: Sensed) -> ForceField:
        """Give what the base class would, looking at the scan once."""
        springs, dampers = self._springs(sensed.scan)
        if dampers is _NO_DAMPING:
            return ForceField(springs, sensed.stick, ZERO_MATRIX)
        x, y, theta = dampers
        along_x, along_y, about = sensed.twist_per_stick
        return ForceField(
            self._damped(springs, dampers, sensed.twist),
            sensed.stick,
            (
                (x * along_x[0], x * along_x[1], x * along_x[2]),
                (y * along_y[0], y * along_y[1], y * along_y[2]),
                (theta * about[0], theta * about[1], theta * about[2]),
            ),
        )

    def touching(self, scan: Scan) -> Penetrations | None:
        """Give the rays that touch, or None when none does."""
        return self.boundary.penetrations(published.clipped(scan) if self.as_published else scan)

    def mean(self, values: Floats, weights: Floats) -> float:
        """Give the mean of values·weights over the touching rays, in m or m²."""
        mean = float(values.dot(weights)) / values.size
        if self.as_published:
            return published.rounded_mean(mean)
        return mean if abs(mean) > _ROUND_OFF else 0.0

    def _springs(self, scan: Scan) -> tuple[PlanarWrench, Vector3]:
        """Give the springs' wrench and the dampers (x, y, theta) that are active beside them."""
        penetrations = self.touching(scan)
        if penetrations is None:
            return _NO_WRENCH, _NO_DAMPING
        touches = self._touches(penetrations, scan)
        fx = 0.0 - self.stiffness.x * self.mean(touches.depth, touches.cos)
        fy = 0.0 - self.stiffness.y * self.mean(touches.depth, touches.sin)
        tau, turning_damping = self.turning(touches, fx, fy)
        return PlanarWrench(fx, fy, tau), (
            self.damping.x if fx else 0.0,
            self.damping.y if fy else 0.0,
            turning_damping if tau else 0.0,
        )

    def _touches(self, penetrations: Penetrations, scan: Scan) -> Touches:
        cos, sin = _directions(np.asarray(scan.angles, np.float64).tobytes(), self.as_published)
        rays, depth, distance, origins = penetrations
        return Touches(depth, distance, cos[rays], sin[rays], origins)

    def _damped(self, springs: PlanarWrench, dampers: Vector3, twist: PlanarTwist) -> PlanarWrench:
        if self.as_published:
            twist = published.rounded_twist(twist)
        return PlanarWrench(
            springs.fx - dampers[0] * twist.vx,
            springs.fy - dampers[1] * twist.vy,
            springs.tau - dampers[2] * twist.omega,
        )


@lru_cache(maxsize=64)
def _directions(angles: bytes, as_published: bool) -> tuple[Floats, Floats]:
    """Give cosine and sine that rays are resolved with; scans repeat their angles."""
    used = np.frombuffer(angles)
    if as_published:
        used = published.previous_angles(used)
    return np.cos(used), np.sin(used)
