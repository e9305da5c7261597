"""One look at a law: what it makes a hand feel in one scene."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from omnistudy.errors.laws import NoForce
from omnistudy.geometry import ForceField, Matrix3, PlanarWrench, Scan, Vector3
from omnistudy.laws.boundary import Penetrations, boundary_of
from omnistudy.laws.law import Law, Sensed
from omnistudy.laws.springs import SpringLaw


@dataclass(frozen=True, slots=True)
class Probe:
    """What a law gives in one scene, unclipped.

    fx, fy, tau : N, N, N·m on the hand, with the stick where and as fast as it was sensed.
    stiffness, damping, about, valid_for : of the field, see ForceField.
    n : rays that touch the boundary; None for a law without one.
    """

    kind: str
    fx: float
    fy: float
    tau: float
    stiffness: Matrix3
    damping: Matrix3
    about: Vector3
    valid_for: float
    n: int | None


def probe(law: Law, sensed: Sensed) -> Probe:
    """Ask a law what it gives for what is sensed; raises NoForce when that is not finite."""
    field = law.field(sensed)
    felt = _felt(field, sensed.stick, sensed.stick_rate)
    if not all(isfinite(value) for value in felt):
        raise NoForce(law.kind, felt)
    return Probe(
        kind=law.kind,
        fx=felt.fx,
        fy=felt.fy,
        tau=felt.tau,
        stiffness=field.stiffness,
        damping=field.damping,
        about=field.about,
        valid_for=field.valid_for,
        n=_count(law, sensed.scan),
    )


def touching(law: Law, scan: Scan) -> Penetrations | None:
    """Give the rays that reach into a law's boundary, None where none does or there is none."""
    if isinstance(law, SpringLaw):
        return law.touching(scan)
    boundary = boundary_of(law)
    return None if boundary is None else boundary.penetrations(scan)


def _count(law: Law, scan: Scan) -> int | None:
    if boundary_of(law) is None:
        return None
    found = touching(law, scan)
    return 0 if found is None else found.rays.size


def _felt(field: ForceField, stick: Vector3, rate: Vector3) -> PlanarWrench:
    """Give the field's wrench at a stick position (m, m, rad) and rate."""
    moved = [at - about for at, about in zip(stick, field.about, strict=True)]
    return PlanarWrench(
        *(
            wrench
            - sum(k * q for k, q in zip(stiffness, moved, strict=True))
            - sum(d * v for d, v in zip(damping, rate, strict=True))
            for wrench, stiffness, damping in zip(
                field.wrench, field.stiffness, field.damping, strict=True
            )
        )
    )
