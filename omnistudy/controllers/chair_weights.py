"""Rules by which the chair's drive and turn are made cheap or dear for the hand's motion.

A weight only penalises: no rule here can make the chair go anywhere the hand does not pull it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from math import inf, isnan
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import Field

from omnistudy.arm.chair import axle
from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.guidance import Guidance
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.registry import Model
from omnistudy.units import Metres, Positive, Radians, Ratio


class Weights(NamedTuple):
    """Weights of the drive (per wheel rad) and the turn (per rad), and what to remember."""

    drive: float
    turn: float
    memory: Any = None


class ChairWeights(Model, ABC):
    """A rule: pure, its memory passed in and out."""

    @abstractmethod
    def weights(self, guidance: Guidance, at: Configuration, memory: Any) -> Weights:
        """Weigh the chair at one step; `memory` is None at the first."""


class FixedWeights(ChairWeights):
    """The same at every step."""

    kind: Literal["fixed"] = "fixed"
    drive: Annotated[Ratio, Positive] = 10.0
    """10 is that of the lab's program of 2007 to 2010; 0.5 while a door opens (p. 127)."""
    turn: Annotated[Ratio, Positive] = 10.0
    """10 is that of the lab's program of 2007 to 2010; 1000 while a door opens (p. 127)."""

    def weights(self, guidance: Guidance, at: Configuration, memory: Any) -> Weights:
        """Give the two numbers."""
        return Weights(self.drive, self.turn)


class PrintedWeights(ChairWeights):
    """As the thesis's program prints them (WMRA_OP, p. 126, and WMRA_OR, p. 131).

    Both go by the unsigned angle between the chair's heading and the hand's path.
    """

    kind: Literal["printed"] = "printed"
    near: Annotated[Radians, Positive] = 0.3
    """Below this angle driving is cheap."""
    drive_near: Annotated[Ratio, Positive] = 1.0
    drive_far: Annotated[Ratio, Positive] = 10.0
    least_turn: Annotated[Ratio, Positive] = 1e-3
    """Ours: at the first step the printed weight is 0, and the program divides by it."""

    def weights(self, guidance: Guidance, at: Configuration, memory: Any) -> Weights:
        """Remember the first angle b; turn = (b^2 - a^2)^2 / (2 b^2 a)."""
        bearing = guidance.heading_wanted()
        angle = 0.0 if isnan(bearing) else abs(wrapped(bearing - at.chair.theta))
        first: float = angle if memory is None else memory
        drive = self.drive_near if angle < self.near else self.drive_far
        room = 2.0 * first * first * angle
        turn = (first * first - angle * angle) ** 2 / room if room > 0.0 else inf
        return Weights(drive, max(turn, self.least_turn), first)


class StagedWeights(ChairWeights):
    """Eq. (22) over the three stages of eq. (17): turn, drive, turn. It does not drive the chair.

    What is to move now is weighed by the reciprocal of the gradient of eq. (21), what is not by
    the gradient; without a goal for the chair both are at rest. Which slot takes which is read
    from the prose of sec. 4.5.2; the place of the tolerance is ours.
    """

    kind: Literal["staged"] = "staged"
    drive: Annotated[Ratio, Positive] = 0.01
    """w_X of eq. (22): not printed, ours."""
    turn: Annotated[Ratio, Positive] = 0.01
    """w_phi of eq. (22): not printed, ours."""
    tolerance: Annotated[Ratio, Positive] = 0.01
    """Added to a gradient before its reciprocal is taken; ours."""
    greatest: Annotated[Ratio, Positive] = 1e6
    """A weight is clipped to this; ours."""
    normalised: bool = True
    """Gradient per half range; false as printed, where it is per rad or per m."""
    arrived_turn: Annotated[Radians, Positive] = 0.02
    """A stage that turns ends this near its end; ours."""
    arrived_drive: Annotated[Metres, Positive] = 0.01
    """The stage that drives ends this near its end; ours."""

    def weights(self, guidance: Guidance, at: Configuration, memory: Any) -> Weights:
        """Remember where the chair began and which stage it is in."""
        goal = guidance.chair_goal
        if goal is None:
            return Weights(1.0, 1.0, memory)
        chair = at.body.profile.chair
        here = axle(chair, at.chair)
        begun: tuple[PlanarPose, int] = memory or (here, 0)
        start, stage = begun
        route = ChairRoute.between(start, axle(chair, goal))
        while stage < 2 and self._arrived(route, stage, here):
            stage += 1
        moving, resting = self._pair(route, stage, here)
        pair = (resting, moving) if stage != 1 else (moving, resting)
        return Weights(
            min(self.drive + pair[0], self.greatest),
            min(self.turn + pair[1], self.greatest),
            (start, stage),
        )

    def _arrived(self, route: ChairRoute, stage: int, here: PlanarPose) -> bool:
        left = abs(route.amounts[stage] - route.done(stage, here))
        return left <= (self.arrived_drive if stage == 1 else self.arrived_turn)

    def _pair(self, route: ChairRoute, stage: int, here: PlanarPose) -> tuple[float, float]:
        """Give the weights of what is to move and of what is to rest."""
        half = route.amounts[stage]
        if half == 0.0:
            return 1.0 / self.tolerance, 0.0
        u = min(abs(1.0 - route.done(stage, here) / half), 1.0)
        gradient = 2.0 * u / (1.0 - u * u) ** 2 if u < 1.0 else inf
        if not self.normalised:
            gradient /= abs(half)
        return 1.0 / (gradient + self.tolerance), gradient


AnyChairWeights = Annotated[
    FixedWeights | PrintedWeights | StagedWeights, Field(discriminator="kind")
]
