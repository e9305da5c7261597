"""Energy that goes into the stick and comes out of it, and damping against what comes out.

Time-domain passivity (Hannaford and Ryu 2002, IEEE Trans. Robotics and Automation 18(1), 1-10): a
force that is held from tick to tick does exactly F·(q' - q) of work, so the sum needs no rates.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from pydantic import Field

from omnistudy.registry import Model
from omnistudy.units import NewtonMetreSeconds, NewtonSecondsPerMetre

LEAST_MOVE = 1e-9
"""m or rad in a tick; damping needs a motion to work on."""


class PassivityObserver:
    """Energy that each axis took from the hand, J; below zero it gave more."""

    def __init__(self, axes: int = 3) -> None:
        self.energy = [0.0] * axes
        self._position: Sequence[float] | None = None
        self._force: Sequence[float] = ()

    def see(self, position: Sequence[float], force: Sequence[float]) -> None:
        """Take a tick's position (m, rad) and the force (N, N·m) that holds from it on."""
        before, held, energy = self._position, self._force, self.energy
        if before is not None:
            for axis in range(len(energy)):
                energy[axis] -= held[axis] * (position[axis] - before[axis])
        self._position, self._force = position, force


class AddedDamping(Model):
    """Damping that takes back what an axis gave out."""

    bound: Annotated[float, Field(le=0)] = -0.02
    """Damping is added while an axis' energy, J, is lower: what 2 N do over 10 mm (ours)."""
    x: Annotated[NewtonSecondsPerMetre, Field(ge=0)] = 20.0
    """At most; about what a relaxed hand has (ours)."""
    y: Annotated[NewtonSecondsPerMetre, Field(ge=0)] = 20.0
    theta: Annotated[NewtonMetreSeconds, Field(ge=0)] = 0.2

    def against(
        self, energy: Sequence[float], moved: Sequence[float], period: float
    ) -> tuple[float, ...]:
        """Give the damping of each axis that would make good its missing energy in one period.

        energy : J. moved : m or rad within the last `period`, s.
        alpha = -E·dt/dq², E counted from `bound` (Hannaford and Ryu 2002, for impedances).
        """
        return tuple(
            0.0
            if e >= self.bound
            else (most if abs(dq) < LEAST_MOVE else min(most, (self.bound - e) * period / dq**2))
            for e, dq, most in zip(energy, moved, (self.x, self.y, self.theta), strict=True)
        )
