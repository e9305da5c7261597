"""From the hand's twist to the rates of joints and chair: what all four published laws share."""

from __future__ import annotations

from abc import abstractmethod
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.configuration import ArmBody, Configuration
from omnistudy.arm.guidance import TWIST, Guidance
from omnistudy.arm.limits import limit_gradient, limit_weights
from omnistudy.arm.step_report import StepReport
from omnistudy.controllers.controller import Control, Controller
from omnistudy.controllers.damping import Damping, DampingName, damping
from omnistudy.controllers.rate_problem import Problem, Solution
from omnistudy.devices import DeviceState
from omnistudy.geometry import ZERO_MATRIX, Matrix3, Scan

Floats = NDArray[np.float64]

LEGACY_RETREAT = -0.01
"""What the lab's program makes of the joints' rates in a zone; the chair goes on."""


class RateMemory(NamedTuple):
    """What a resolved-rate controller remembers from one step to the next.

    gradient : derivative of the limits' potential, as the step before left it, (n,).
    weights : what the rule of the chair's weights remembers.
    """

    gradient: Floats | None = None
    weights: Any = None
    report: StepReport = StepReport()


class ResolvedRateController(Controller):
    """Frames, limits, stops and zones round a solver of J V = r (Farelo 2009, WMRA_Opt)."""

    frame: Literal["ground", "wheelchair", "gripper"] = "ground"
    """In whose axes the device gives the hand's twist."""
    follows: Literal["pose", "position"] = "pose"
    moves: Literal["both", "arm", "chair"] = "both"
    avoid_limits: bool = True
    """Joints get dearer, or are pushed off, near their limits."""
    limit_memory: Literal["legacy", "kept"] = "kept"
    """`legacy` compares with a gradient already set to zero, and so chatters; as in 2009."""
    limit_stop: Literal["none", "legacy", "one_sided"] = "one_sided"
    """`legacy` freezes a joint at its limit for ever, and the hand leaves its path."""
    speed_limits: Literal["none", "legacy", "uniform"] = "uniform"
    """`legacy` clips each joint by itself, which bends the path; `uniform` slows all."""
    zones: Literal["none", "legacy", "stop"] = "stop"
    """`legacy` sends the joints back while the chair drives on; `stop` halts all."""

    @property
    def twist_per_stick(self) -> Matrix3:
        """No law damps an arm: nothing."""
        return ZERO_MATRIX

    def initial_state(self) -> RateMemory:
        """Nothing is remembered yet."""
        return RateMemory()

    def control(
        self, device: DeviceState, plant_state: Any, scan: Scan | None, state: Any, dt: float
    ) -> Control:
        """Take a twist and perhaps the chair's goal; give (n + 2) rates: joints, drive, turn."""
        configuration: Configuration = plant_state.configuration
        memory: RateMemory = state
        guidance = self._in_ground_axes(Guidance.read(device.position), configuration)
        gradient, added = self._limits(configuration, memory.gradient)
        free, weights_memory = self._inverse_weights(guidance, configuration, added, memory)
        slope = self._slope(gradient, added)
        problem = self._problem(guidance, configuration, free, slope)
        solution, hits = self._solve_within_limits(problem, configuration, dt)
        rates, held = self._held_back(solution.rates, configuration, dt)
        hits += held + (("singular",) if solution.singular else ())
        remembered = gradient if self.limit_memory == "kept" else np.sign(gradient) * added
        report = StepReport(solution.manipulability, solution.damping, hits)
        asked = device.position[:TWIST]
        return Control(asked, rates, RateMemory(remembered, weights_memory, report))

    @abstractmethod
    def solve(self, problem: Problem, damping: Damping | None) -> Solution:
        """Solve one step; `damping` is None for a law or a part that is not damped."""

    @property
    def damping_name(self) -> DampingName | None:
        """Which damping the law has; None for a pseudo-inverse."""
        return None

    def _slope(self, gradient: Floats, added: Floats) -> Floats:
        """Give what the null space slides along, (n,): the gradient. Laws may leave some out."""
        return gradient

    def _inverse_weights(
        self, guidance: Guidance, configuration: Configuration, added: Floats, memory: RateMemory
    ) -> tuple[Floats, Any]:
        """Weigh all joints as 1; the chair by its wheels' radians. Laws may weigh otherwise."""
        count = configuration.body.count
        free = np.ones(count + 2)
        free[count] = configuration.body.profile.chair.wheel_radius**2
        return free, None

    def _in_ground_axes(self, guidance: Guidance, configuration: Configuration) -> Guidance:
        if self.frame == "ground":
            return guidance
        frame = configuration.base if self.frame == "wheelchair" else configuration.hand
        turned = (frame[:3, :3] @ guidance.twist.reshape(2, 3).T).T.reshape(6)
        return guidance._replace(twist=turned)

    def _limits(self, configuration: Configuration, before: Floats | None) -> tuple[Floats, Floats]:
        """Give the gradient of the limits' potential and what it adds to the weights."""
        body = configuration.body
        if not self.avoid_limits:
            nothing = np.zeros(body.count)
            return nothing, nothing
        gradient = limit_gradient(configuration.joints, body.lower, body.upper)
        last = np.zeros(body.count) if before is None else before
        return gradient, limit_weights(gradient, last, configuration.joints, body.lower, body.upper)

    def _problem(
        self, guidance: Guidance, configuration: Configuration, free: Floats, gradient: Floats
    ) -> Problem:
        count = configuration.body.count
        rows, wanted = configuration.jacobian, guidance.twist
        if self.follows == "position":
            rows, wanted = rows[:3], wanted[:3]
        if self.moves == "arm":
            free[count:] = 0.0
        elif self.moves == "chair":
            free[:count] = 0.0
            rows, wanted = rows[:2], wanted[:2]
        return Problem(
            rows,
            wanted,
            free,
            np.concatenate((gradient, (0.0, 0.0))),
            configuration.body.top_rates,
        )

    @cached_property
    def _damping(self) -> Damping | None:
        if self.moves == "chair" or self.damping_name is None:
            return None
        return damping(self.damping_name, self.moves == "both", 6 if self.follows == "pose" else 3)

    def _solve_within_limits(
        self, problem: Problem, configuration: Configuration, dt: float
    ) -> tuple[Solution, tuple[str, ...]]:
        """Solve; where a joint would pass its limit, solve again with it at rest."""
        solution = self.solve(problem, self._damping)
        if self.limit_stop == "none":
            return solution, ()
        body, joints = configuration.body, configuration.joints
        if self.limit_stop == "legacy":
            frozen = (joints >= body.upper) | (joints <= body.lower)
            solution.rates[: body.count][frozen] = 0.0
            return solution, _named("limit", frozen)
        stopped = np.zeros(body.count, dtype=np.bool_)
        for _ in range(body.count):
            # a rate that will be slowed anyhow does not pass a limit
            rates = self._slowed(solution.rates, body)[0][: body.count]
            after = joints + rates * dt
            passing = ((after > body.upper) & (rates > 0.0)) | (
                (after < body.lower) & (rates < 0.0)
            )
            if not passing.any():
                break
            stopped |= passing
            problem.free[: body.count][stopped] = 0.0
            solution = self.solve(problem, self._damping)
        return solution, _named("limit", stopped)

    def _held_back(
        self, rates: Floats, configuration: Configuration, dt: float
    ) -> tuple[Floats, tuple[str, ...]]:
        """Apply the speed limits and the zones."""
        rates, hits = self._slowed(rates, configuration.body)
        if self.zones == "none" or self.moves == "chair":
            return rates, hits
        ahead = configuration.moved(rates, dt).intrusions
        if not ahead.names:
            return rates, hits
        if self.zones == "legacy":
            rates[: configuration.body.count] *= LEGACY_RETREAT
        elif not ahead.deeper_than(configuration.intrusions):
            return rates, hits
        else:
            rates = np.zeros_like(rates)
        return rates, hits + tuple(f"zone {name}" for name in ahead.names)

    def _slowed(self, rates: Floats, body: ArmBody) -> tuple[Floats, tuple[str, ...]]:
        if self.speed_limits == "none":
            return rates, ()
        top = body.top_rates
        over = np.abs(rates) / top
        most = float(over.max())
        if most <= 1.0:
            return rates, ()
        hits = _named("speed", over > 1.0)
        if self.speed_limits == "legacy":
            return np.clip(rates, -top, top), hits
        return rates / most, hits


def _named(what: str, which: NDArray[np.bool_]) -> tuple[str, ...]:
    return tuple(f"{what} {index + 1}" for index in which.nonzero()[0]) if which.any() else ()
