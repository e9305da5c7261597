"""The greatest force that somebody wants to meet, never above what the protocol allows."""

from __future__ import annotations

from typing import Annotated

from omnistudy.devices.device import DeviceState
from omnistudy.devices.stick_scale import (
    FORCE_AT_FULL_DUTY,
    FULL_DUTY,
    TORQUE_AT_FULL_DUTY,
)
from omnistudy.geometry import ForceField, PlanarWrench
from omnistudy.geometry.force_field import Matrix3
from omnistudy.registry import Model
from omnistudy.units import NewtonMetres, Newtons, Positive


class Ceiling(Model):
    """Greatest force on each axis, whatever a law asks."""

    x: Annotated[Newtons, Positive] = FORCE_AT_FULL_DUTY
    y: Annotated[Newtons, Positive] = FORCE_AT_FULL_DUTY
    theta: Annotated[NewtonMetres, Positive] = TORQUE_AT_FULL_DUTY

    @property
    def forces(self) -> tuple[float, float, float]:
        """N, N, N·m."""
        return (self.x, self.y, self.theta)

    def under(self, other: Ceiling) -> Ceiling:
        """Give what both allow."""
        x, y, theta = (min(pair) for pair in zip(self.forces, other.forces, strict=True))
        return Ceiling(x=x, y=y, theta=theta)

    def duties(self, per_duty: tuple[float, float, float]) -> tuple[int, int, int]:
        """Give the greatest PWM steps that stay below it; per_duty in N, N, N·m a step."""
        x, y, theta = (
            max(0, min(int(FULL_DUTY), int(force / step + 1e-9)))
            for force, step in zip(self.forces, per_duty, strict=True)
        )
        return (x, y, theta)

    def bound(self, field: ForceField, state: DeviceState) -> ForceField:
        """Shrink the field so that, where the device now is, no axis exceeds its ceiling.

        Wrench, stiffness and damping of an axis shrink together: its direction stays.
        """
        shares = tuple(
            most / abs(force) if abs(force) > most else 1.0
            for force, most in zip(_force(field, state), self.forces, strict=True)
        )
        if shares == (1.0, 1.0, 1.0):
            return field
        a, b, c = shares
        wrench, stiffness, damping = field.wrench, field.stiffness, field.damping
        return field._replace(
            wrench=PlanarWrench(a * wrench[0], b * wrench[1], c * wrench[2]),
            stiffness=_rows(stiffness, shares),
            damping=_rows(damping, shares),
        )


NO_CEILING = Ceiling()
"""What the published stick can push at most (Tyagi 2017, ch. 2)."""


def _rows(matrix: Matrix3, shares: tuple[float, ...]) -> Matrix3:
    a, b, c = (
        (share * row[0], share * row[1], share * row[2])
        for row, share in zip(matrix, shares, strict=True)
    )
    return (a, b, c)


def _force(field: ForceField, state: DeviceState) -> tuple[float, ...]:
    away = [q - about for q, about in zip(state.position[:3], field.about, strict=True)]
    return tuple(
        field.wrench[axis]
        - sum(k * q for k, q in zip(field.stiffness[axis], away, strict=True))
        - sum(d * v for d, v in zip(field.damping[axis], state.rate[:3], strict=True))
        for axis in range(3)
    )
