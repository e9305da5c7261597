"""Weighted least norm: the motion that costs least by weights (eq. 14 to 16)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.configuration import Configuration
from omnistudy.arm.guidance import Guidance
from omnistudy.controllers.chair_weights import AnyChairWeights, FixedWeights
from omnistudy.controllers.damping import Damping
from omnistudy.controllers.rate_problem import Inverse, Problem, Solution
from omnistudy.controllers.resolved_rate import RateMemory, ResolvedRateController

Floats = NDArray[np.float64]


class WeightedLeastNorm(ResolvedRateController):
    """Each joint weighs 1 and its nearness to a limit; the chair by a rule."""

    chair_weights: AnyChairWeights = FixedWeights()

    def solve(self, problem: Problem, damping: Damping | None) -> Solution:
        """Give the cheapest rates that do what is wanted, damped or not."""
        inverse = Inverse.of(problem, damping)
        if inverse.singular:
            return Solution(np.zeros_like(problem.free), inverse.manipulability, 0.0, True)
        rates = inverse.times(problem.wanted)
        return Solution(rates, inverse.manipulability, inverse.damping)

    def _inverse_weights(
        self, guidance: Guidance, configuration: Configuration, added: Floats, memory: RateMemory
    ) -> tuple[Floats, Any]:
        weights = self.chair_weights.weights(guidance, configuration, memory.weights)
        radius = configuration.body.profile.chair.wheel_radius
        count = configuration.body.count
        free = np.empty(count + 2)
        free[:count] = 1.0 / (1.0 + added)
        free[count] = radius * radius / weights.drive
        free[count + 1] = 1.0 / weights.turn
        return free, weights.memory
