"""The condition without feedback."""

from __future__ import annotations

from typing import Literal

from omnistudy.geometry import ZERO_MATRIX, ForceField, PlanarWrench
from omnistudy.laws.law import Law, Sensed


class NoLaw(Law):
    """No feedback: only the stick's own centring is felt (Tyagi 2017, ch. 4, trials T4-T6)."""

    kind: Literal["none"] = "none"

    def field(self, sensed: Sensed) -> ForceField:
        """Give a zero field, whatever is sensed."""
        return ForceField(PlanarWrench(0.0, 0.0, 0.0), sensed.stick, ZERO_MATRIX)
