"""Singularity-robust inverse with weighted least norm: the thesis's "optim = 1"."""

from __future__ import annotations

from typing import Literal

from omnistudy.controllers.damping import DampingName
from omnistudy.controllers.weighted_least_norm import WeightedLeastNorm


class SriWln(WeightedLeastNorm):
    """Damped near singular configurations by eq. (12), (13)."""

    kind: Literal["sri_wln"] = "sri_wln"
    damping: DampingName = "scaled"
    """`legacy`: one k for mm and rad, as printed; `scaled`: a radian counts as half a metre."""

    @property
    def damping_name(self) -> DampingName | None:
        """Give the damping."""
        return self.damping
