"""Pseudo-inverse with weighted least norm: the thesis's "optim = 2"."""

from __future__ import annotations

from typing import Literal

from omnistudy.controllers.weighted_least_norm import WeightedLeastNorm


class PiWln(WeightedLeastNorm):
    """Undamped: exact, and without an answer where the arm is singular; it then stands still."""

    kind: Literal["pi_wln"] = "pi_wln"
