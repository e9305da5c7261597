"""Pseudo-inverse with projected gradient: the thesis's "optim = 4"."""

from __future__ import annotations

from typing import Literal

from omnistudy.controllers.projected_gradient import ProjectedGradient


class PiEne(ProjectedGradient):
    """Undamped: exact, and without an answer where the arm is singular; it then stands still."""

    kind: Literal["pi_ene"] = "pi_ene"
