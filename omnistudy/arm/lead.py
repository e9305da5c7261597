"""Where hand, chair and joints are to be at one share of a motion's time."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.chair import base_frame
from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.configuration import ArmBody
from omnistudy.arm.paths import LinePath, Path
from omnistudy.arm.timing import Timing
from omnistudy.geometry import PlanarPose

Floats = NDArray[np.float64]


class Lead(ABC):
    """One parameter, the share `u` of the time (0 to 1), for hand, chair and joints."""

    @abstractmethod
    def hand(self, u: float) -> Floats:
        """Give the hand's pose (4, 4), in ground axes."""

    def chair(self, u: float) -> PlanarPose | None:
        """Give the wheelchair's pose; None when it goes as it likes."""
        return None

    def joints(self, u: float) -> Floats | None:
        """Give the joints (n,) that suit best, rad; None when none do."""
        return None


@dataclass(frozen=True, eq=False)
class ChairLead:
    """The chair's way: its route at its limits, in the motion's timing."""

    body: ArmBody
    route: ChairRoute
    timing: Timing

    def pose(self, u: float) -> PlanarPose:
        """Give the wheelchair's pose at the arm's base."""
        chair = self.body.profile.chair
        return self.route.chair_pose(chair, self.route.shares(u, chair, self.timing))


@dataclass(frozen=True, eq=False)
class PostureLead:
    """From one posture of the joints to another, evenly."""

    start: Floats
    goal: Floats
    timing: Timing

    def at(self, u: float) -> Floats:
        """Give the joints (n,), rad."""
        return self.start + self.timing.share(u) * (self.goal - self.start)


@dataclass(frozen=True, eq=False)
class WorldLead(Lead):
    """The hand keeps to its path over the ground, as it must where it touches something."""

    path: Path
    timing: Timing
    way: ChairLead | None = None
    posture: PostureLead | None = None

    def hand(self, u: float) -> Floats:
        """Give the pose on the path."""
        return self.path.pose(self.timing.share(u))

    def chair(self, u: float) -> PlanarPose | None:
        """Give the pose on the chair's own way, if it has one."""
        return None if self.way is None else self.way.pose(u)

    def joints(self, u: float) -> Floats | None:
        """Give the posture, if one is wanted."""
        return None if self.posture is None else self.posture.at(u)


@dataclass(frozen=True, eq=False)
class CarriedLead(Lead):
    """The hand goes straight as the chair sees it, and the chair carries it.

    For free space only: over the ground its path is bent. Start and goal are what they were.
    """

    seen: LinePath
    timing: Timing
    way: ChairLead
    posture: PostureLead

    def hand(self, u: float) -> Floats:
        """Give the pose in the chair's axes, carried to where the chair is."""
        base = base_frame(self.way.body.profile.chair, self.way.pose(u))
        hand: Floats = base @ self.seen.pose(self.timing.share(u))
        return hand

    def chair(self, u: float) -> PlanarPose:
        """Give the pose on the chair's own way."""
        return self.way.pose(u)

    def joints(self, u: float) -> Floats:
        """Give the posture."""
        return self.posture.at(u)


@dataclass(frozen=True, eq=False)
class FoldedLead(Lead):
    """The joints go evenly through some postures while the chair carries them; free space only.

    Never singular and never past a joint's limit, whatever lies between start and goal.
    """

    postures: tuple[Floats, ...]
    timing: Timing
    way: ChairLead

    @cached_property
    def _ends(self) -> Floats:
        """Shares of the path at which the postures are, by the greatest change of a joint."""
        changes = [np.abs(b - a).max() for a, b in pairwise(self.postures)]
        done = np.cumsum([0.0, *changes])
        return done / done[-1] if done[-1] > 0.0 else np.linspace(0.0, 1.0, len(done))

    def joints(self, u: float) -> Floats:
        """Give the joints (n,), rad."""
        share = self.timing.share(u)
        columns = np.array(self.postures).T
        return np.array([np.interp(share, self._ends, column) for column in columns])

    def hand(self, u: float) -> Floats:
        """Give the pose that the postures lead to."""
        base = base_frame(self.way.body.profile.chair, self.way.pose(u))
        hand: Floats = base @ self.way.body.frames(self.joints(u))[-1]
        return hand

    def chair(self, u: float) -> PlanarPose:
        """Give the pose on the chair's own way."""
        return self.way.pose(u)
