"""What a full effect of a bought stick is in newtons, from readings of an instrument."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
from scipy.stats import t as student

from omnistudy.devices.handheld.force_effects import Strength
from omnistudy.errors.handheld import NoForceFelt

TOWARDS = 0.975
"""Quantile of Student's t for a two-sided interval of 95 %."""
LEAST_SURE = 0.5
"""A half-width of more than this part of the force is no force (ours)."""


class Push(NamedTuple):
    """A push along one axis of the stick (0 x, 1 y): part of a full effect, -1 to 1."""

    axis: int
    share: float


class PushRead(NamedTuple):
    """What an instrument read of a push, N; forward and left are positive."""

    push: Push
    force: float


class FullForce(NamedTuple):
    """Force of a full effect, N, and half the width of its 95 % interval.

    turned : whether the driver takes a push's direction the other way round.
    """

    force: float
    half_width: float
    turned: bool


def pushes(axes: Sequence[int], levels: int) -> tuple[Push, ...]:
    """Give the pushes of each axis: none, then both ways in turns, ever stronger."""
    sizes = [n / levels for n in range(1, levels + 1)]
    shares = (0.0, *(share for size in sizes for share in (size, -size)))
    return tuple(Push(axis, share) for axis in axes for share in shares)


def full_force(reads: Sequence[PushRead], turned: bool) -> FullForce:
    """Fit force = zero of the axis + full·share by least squares, one `full` for all axes.

    turned : whether the pushes were already turned. Raises NoForceFelt.
    """
    axes = sorted({read.push.axis for read in reads})
    rows = np.array(
        [[read.push.share, *(float(read.push.axis == axis) for axis in axes)] for read in reads]
    )
    force = np.array([read.force for read in reads])
    found, *_ = np.linalg.lstsq(rows, force, rcond=None)
    freedom = len(reads) - rows.shape[1]
    variance = float(((force - rows @ found) ** 2).sum()) / freedom
    spread = float(np.linalg.inv(rows.T @ rows)[0, 0])
    full = float(found[0])
    half_width = float(student.ppf(TOWARDS, freedom)) * sqrt(variance * spread)
    if half_width > LEAST_SURE * abs(full) or full == 0.0:
        raise NoForceFelt(full, half_width)
    return FullForce(abs(full), half_width, turned != (full < 0.0))


def measured(before: Strength, found: FullForce, said: str) -> Strength:
    """Give the strength as it was found; `said` tells when and with what."""
    return before.model_copy(
        update={
            "force": round(found.force, 3),
            "turned": found.turned,
            "measured": f"{said}; ± {found.half_width:.2g} N (95 %)",
        }
    )
