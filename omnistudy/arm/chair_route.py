"""The chair's own way in three stages: turn to face it, drive, turn at its end (eq. 17)."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

from omnistudy.arm.chair import axle, pose_of_axle
from omnistudy.arm.profile import Chair
from omnistudy.arm.timing import Timing
from omnistudy.geometry import PlanarPose, wrapped


class ChairRoute(NamedTuple):
    """From one pose to another by turning, driving straight and turning.

    start : where it begins.
    amounts : first turn in rad, way in m (negative backwards), last turn in rad; all signed, turns
        the short way round, which the thesis's eq. (17) forgets.
    """

    start: PlanarPose
    amounts: tuple[float, float, float]

    @classmethod
    def between(cls, start: PlanarPose, goal: PlanarPose, may_reverse: bool = False) -> ChairRoute:
        """Plan for a point that the chair turns about; `may_reverse` backs up when that is less."""
        dx, dy = goal.x - start.x, goal.y - start.y
        way = hypot(dx, dy)
        if way == 0.0:
            return cls(start, (wrapped(goal.theta - start.theta), 0.0, 0.0))
        forward = cls._through(start, goal, atan2(dy, dx), way)
        if not may_reverse:
            return forward
        backward = cls._through(start, goal, wrapped(atan2(dy, dx) + pi), -way)
        return min(forward, backward, key=lambda r: abs(r.amounts[0]) + abs(r.amounts[2]))

    @classmethod
    def of_chair(
        cls, chair: Chair, start: PlanarPose, goal: PlanarPose, may_reverse: bool = False
    ) -> ChairRoute:
        """Plan for a wheelchair, given its poses at the arm's base: the route is its axle's."""
        return cls.between(axle(chair, start), axle(chair, goal), may_reverse)

    @classmethod
    def _through(
        cls, start: PlanarPose, goal: PlanarPose, heading: float, way: float
    ) -> ChairRoute:
        return cls(start, (wrapped(heading - start.theta), way, wrapped(goal.theta - heading)))

    def duration(self, chair: Chair, timing: Timing) -> float:
        """Give the seconds it takes at the chair's limits."""
        return timing.peak * sum(self._needs(chair))

    def _needs(self, chair: Chair) -> tuple[float, float, float]:
        """Give the seconds of each stage at the chair's greatest speeds."""
        first, way, last = (abs(amount) for amount in self.amounts)
        return first / chair.top_turn, way / chair.top_speed, last / chair.top_turn

    def shares(self, u: float, chair: Chair, timing: Timing) -> tuple[float, float, float]:
        """Give how much of each stage is done at the share `u` of the time.

        Each stage takes time by what it needs at the chair's limits, and has its own timing.
        """
        needs = self._needs(chair)
        left = u * sum(needs)
        done = []
        for need in needs:
            part = min(left / need, 1.0) if need > 0.0 else 1.0
            done.append(timing.share(part))
            left = max(left - need, 0.0)
        return done[0], done[1], done[2]

    def pose(self, shares: tuple[float, float, float]) -> PlanarPose:
        """Give the pose when these shares (0 to 1) of the three stages are done."""
        first, way, last = (a * s for a, s in zip(self.amounts, shares, strict=True))
        heading = self.start.theta + self.amounts[0]
        return PlanarPose(
            self.start.x + way * cos(heading),
            self.start.y + way * sin(heading),
            self.start.theta + first + last,
        )

    def chair_pose(self, chair: Chair, shares: tuple[float, float, float]) -> PlanarPose:
        """Give the wheelchair's pose, at the arm's base, on a route of its axle."""
        return pose_of_axle(chair, self.pose(shares))

    def done(self, stage: int, pose: PlanarPose) -> float:
        """Give how much of a stage (0, 1, 2) is done at a pose, in the unit of its amount."""
        heading = self.start.theta + self.amounts[0]
        if stage == 1:
            dx, dy = pose.x - self.start.x, pose.y - self.start.y
            return dx * cos(heading) + dy * sin(heading)
        return wrapped(pose.theta - (self.start.theta if stage == 0 else heading))
