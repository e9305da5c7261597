"""Ways in which hand and chair together may do a motion, the nearest first."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.chair import axle, base_frame
from omnistudy.arm.chair_route import ChairRoute
from omnistudy.arm.configuration import Configuration
from omnistudy.arm.detour import detour
from omnistudy.arm.lead import CarriedLead, ChairLead, FoldedLead, Lead, PostureLead, WorldLead
from omnistudy.arm.paths import LinePath
from omnistudy.arm.postures import postures
from omnistudy.arm.stand_off import RADIAN, nearest_stand_off
from omnistudy.arm.task import Motion
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.geometry.rigid_motion import inverse

Floats = NDArray[np.float64]

HEADINGS = tuple(k * pi / 4 for k in (0, 1, -1, 2, -2, 3, -3, 4))
"""rad, of the chair from where it stands, that a stand-off may have; ours."""

REACHES = tuple((x, y) for x in (0.35, 0.6, 0.85) for y in (-0.25, 0.1, 0.45))
"""m from the arm's base to the hand in a stand-off, in axes of the chair; ours."""

NO_WAY = (0.0, 0.0, 0.0)

STRAIGHT = (-0.3, 0.3, -0.6, 0.6, -0.9, -1.2)
"""m that the chair may go straight while the hand keeps to a path over the ground; ours."""


class Way(NamedTuple):
    """One way: what leads, how long it takes at full speed in s, and what it is in words."""

    lead: Lead
    duration: float
    says: str


def ways(motion: Motion, at: Configuration) -> Iterator[Way]:
    """Think of ways to do a motion from where arm and chair are."""
    if motion.hinge is not None or (motion.chair_goal is None and not motion.carried):
        yield from _over_ground(motion, at)
        return
    goal = motion.path(at.hand, at.base).pose(1.0)
    for chair in _stand_offs(motion, at, goal):
        base = base_frame(at.body.profile.chair, chair)
        seen = inverse(base) @ goal
        for joints in postures(at.body, seen, at.joints):
            yield from _to(motion, at, chair, joints)


def _stand_offs(motion: Motion, at: Configuration, goal: Floats) -> Iterator[PlanarPose]:
    """Give chair poses to end at: the given one, or the nearest and then a grid, nearest first."""
    if motion.chair_goal is not None:
        yield motion.chair_goal.pose
        return
    nearest = nearest_stand_off(at, goal)
    if not nearest.reached:
        return
    yield nearest.configuration.chair
    grid = []
    for heading in HEADINGS:
        theta = wrapped(at.chair.theta + heading)
        for x, y in REACHES:
            way = PlanarPose(0.0, 0.0, theta).to_world(x, y)
            grid.append(PlanarPose(goal[0, 3] - way[0], goal[1, 3] - way[1], theta))
    yield from sorted(grid, key=lambda pose: _distance(at.chair, pose))


def _distance(one: PlanarPose, two: PlanarPose) -> float:
    way = float(np.hypot(two.x - one.x, two.y - one.y))
    return way + RADIAN * abs(wrapped(two.theta - one.theta))


def _to(motion: Motion, at: Configuration, goal: PlanarPose, joints: Floats) -> Iterator[Way]:
    """Go to a chair pose and a posture."""
    chair, timing = at.body.profile.chair, motion.timing
    route = ChairRoute.of_chair(chair, at.chair, goal, may_reverse=True)
    way = ChairLead(at.body, route, timing)
    path = motion.path(at.hand, at.base)
    driving = route.duration(chair, timing)
    posture = PostureLead(at.joints, joints, timing)
    if not motion.carried:
        duration = max(motion.hand_duration(path), driving)
        yield Way(
            WorldLead(path, timing, way, posture),
            duration,
            "over the ground while the chair turns, drives and turns",
        )
        return
    end = at.body.frames(joints)[-1]
    seen = LinePath(at.frames[-1], end)
    duration = max(motion.hand_duration(path), motion.hand_duration(seen), driving)
    yield Way(CarriedLead(seen, timing, way, posture), duration, "carried by the chair")
    folds = detour(at.body, at.joints, joints)
    if folds:
        turning = sum(_folding(at, a, b) for a, b in pairwise(folds))
        duration = max(motion.hand_duration(path), turning * timing.peak, driving)
        yield Way(FoldedLead(folds, timing, way), duration, "folded on the chair")


def _folding(at: Configuration, begin: Floats, end: Floats) -> float:
    """Give the seconds from one posture to another at the joints' greatest rates."""
    top = at.body.top_rates[: at.body.count]
    return float((np.abs(end - begin) / top).max())


def _over_ground(motion: Motion, at: Configuration) -> Iterator[Way]:
    """Keep the hand to its path: the chair stands, goes as it likes, or goes straight."""
    path, timing = motion.path(at.hand, at.base), motion.timing
    if not nearest_stand_off(at, path.pose(1.0)).reached:
        return
    chair = at.body.profile.chair
    hand = motion.hand_duration(path)
    still = ChairLead(at.body, ChairRoute(axle(chair, at.chair), NO_WAY), timing)
    yield Way(WorldLead(path, timing, still), hand, "over the ground while the chair stands")
    yield Way(WorldLead(path, timing), hand, "over the ground while the chair goes as it likes")
    for way in STRAIGHT:
        route = ChairRoute(axle(chair, at.chair), (0.0, way, 0.0))
        duration = max(hand, route.duration(chair, timing))
        says = f"over the ground while the chair goes {way:+.1f} m"
        yield Way(WorldLead(path, timing, ChairLead(at.body, route, timing)), duration, says)
