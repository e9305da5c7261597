"""Singularity-robust inverse with projected gradient: the thesis's "optim = 3"."""

from __future__ import annotations

from typing import Literal

from omnistudy.controllers.damping import DampingName
from omnistudy.controllers.projected_gradient import ProjectedGradient


class SriEne(ProjectedGradient):
    """Damped near singular configurations by eq. (12), (13)."""

    kind: Literal["sri_ene"] = "sri_ene"
    damping: DampingName = "scaled"
    """`legacy`: one k for mm and rad, as printed; `scaled`: a radian counts as half a metre."""

    @property
    def damping_name(self) -> DampingName | None:
        """Give the damping."""
        return self.damping
