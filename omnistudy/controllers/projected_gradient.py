"""Least norm, and in its null space a slide away from the joints' limits."""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from omnistudy.controllers.damping import Damping
from omnistudy.controllers.rate_problem import Inverse, Problem, Solution
from omnistudy.controllers.resolved_rate import ResolvedRateController
from omnistudy.units import Ratio

Floats = NDArray[np.float64]

STEEPEST = 1e6
"""1/rad: a gradient, infinite at a limit, is clipped to this; ours."""


class ProjectedGradient(ResolvedRateController):
    """V = J# r - gain (I - J# J) dH (Farelo 2009, WMRA_Opt, p. 128), nothing weighted."""

    gain: Annotated[Ratio, Field(ge=0)] = 0.02
    """1/s: the printed 0.001 a step of 0.05 s."""
    slide: Literal["legacy", "away"] = "away"
    """`legacy` has the printed plus sign, towards the limits, no bound, and leaves out what moves
    away from its limit; `away` is kept within the top rates."""

    def _slope(self, gradient: Floats, added: Floats) -> Floats:
        return np.sign(gradient) * added if self.slide == "legacy" else gradient

    def solve(self, problem: Problem, damping: Damping | None) -> Solution:
        """Give the least rates that do what is wanted, with the slide."""
        inverse = Inverse.of(problem, damping)
        if inverse.singular:
            return Solution(np.zeros_like(problem.free), inverse.manipulability, 0.0, True)
        downhill = np.where(problem.free > 0.0, problem.gradient, 0.0)
        downhill = np.clip(downhill, -STEEPEST, STEEPEST)
        slide = downhill - inverse.times(problem.rows @ downhill)
        if self.slide == "legacy":
            slide *= self.gain
        else:
            slide *= -self.gain
            slide /= max(1.0, float((np.abs(slide) / problem.top_rates).max()))
        rates = inverse.times(problem.wanted) + slide
        return Solution(rates, inverse.manipulability, inverse.damping)
