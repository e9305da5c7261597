"""From where on the floor the hand can be brought to a pose, nearest first."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, hypot, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.configuration import Configuration
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.geometry.rigid_motion import pose_error

Floats = NDArray[np.float64]

NEAR_ENOUGH = (1e-5, 1e-4)
"""m and rad within which a pose counts as reached."""

RADIAN = 0.5
"""m that a radian counts as, of the hand and of the chair."""

HEADINGS = (0.0, pi / 4, -pi / 4, pi / 2, -pi / 2, 3 * pi / 4, -3 * pi / 4, pi)
"""Turns of the chair from where it stands with which the search begins, rad."""

SEARCH_STEPS = 100
FURTHEST_STEP = 0.3
"""Of the search: most that a joint (rad) or the chair (m, rad) changes at once."""

SETTLED = 1e-6
"""Change (rad, m) of a step below which the search is over."""

MARGIN = 0.02
"""rad kept from the joints' limits."""


class StandOff(NamedTuple):
    """One answer: a chair pose with joints, and how well the hand is where it should be.

    distance : of the chair from where it stands now, m. turn : of the chair, rad.
    short : m, and rad, by which the hand misses its pose; both are about 0 when it is reached.
    """

    configuration: Configuration
    distance: float
    turn: float
    short: tuple[float, float]

    @property
    def reached(self) -> bool:
        """Whether the hand is where it should be."""
        return self.short[0] <= NEAR_ENOUGH[0] and self.short[1] <= NEAR_ENOUGH[1]

    @property
    def clear(self) -> bool:
        """Whether the arm enters no zone."""
        return not self.configuration.intrusions.names

    @property
    def cost(self) -> float:
        """How far it is from here, in m."""
        return self.distance + RADIAN * abs(self.turn)


def nearest_stand_off(now: Configuration, goal: Floats, *, may_drive: bool = True) -> StandOff:
    """Give the nearest chair pose found from which the hand has its goal (4, 4), limits kept.

    Answers that enter no zone come before nearer ones that do. If there is none at all, give
    where the hand comes nearest. `may_drive` false leaves the chair where it is. The chair is
    moved freely over the floor here; how it gets there is another question.
    """
    still = _best(_postures(now), now.chair, goal, may_drive=False)
    if not may_drive or (still.reached and still.clear):
        return still
    return min(still, _best(_round(now, goal), now.chair, goal, may_drive=True), key=_rank)


def _best(
    begins: Iterator[Configuration], home: PlanarPose, goal: Floats, *, may_drive: bool
) -> StandOff:
    answers = (answer for begin in begins for answer in _search(begin, home, goal, may_drive))
    return min(answers, key=_rank)


def _rank(answer: StandOff) -> tuple[bool, float, bool, float]:
    if not answer.reached:
        return True, answer.short[0] + RADIAN * answer.short[1], False, 0.0
    return False, 0.0, not answer.clear, answer.cost


def _postures(now: Configuration) -> Iterator[Configuration]:
    """Begin where the chair stands, with several postures."""
    body = now.body
    ready = np.array(body.profile.ready)
    mirrored = ready * np.array([1.0 if i % 2 else -1.0 for i in range(body.count)])
    middle = 0.5 * (body.lower + body.upper)
    for joints in (now.joints, ready, mirrored, 0.5 * (ready + middle)):
        yield Configuration(body, joints, now.chair)


def _round(now: Configuration, goal: Floats) -> Iterator[Configuration]:
    """Begin with the hand above or below its goal, at several headings of the chair."""
    for heading in HEADINGS:
        for posture in _postures(now):
            chair = now.chair._replace(theta=now.chair.theta + heading)
            hand = Configuration(now.body, posture.joints, chair).hand
            x, y = (goal[:2, 3] - hand[:2, 3]).tolist()
            place = PlanarPose(chair.x + x, chair.y + y, chair.theta)
            yield Configuration(now.body, posture.joints, place)


def _search(
    begin: Configuration, home: PlanarPose, goal: Floats, may_drive: bool
) -> Iterator[StandOff]:
    """Go down to the goal, and in what freedom is left towards where the chair stands now.

    Every other step only mends what the step towards home has spoilt. Yields each answer that is
    better than those before it, or the last attempt.
    """
    at, best = begin, None
    for attempt in range(SEARCH_STEPS):
        mends = attempt % 2 == 1
        change = _change(at, at.chair if mends else home, goal, may_drive)
        change /= max(1.0, float(np.abs(change).max()) / FURTHEST_STEP)
        at = _changed(at, change)
        answer = _measured(at, home, goal)
        if answer.reached and (best is None or _rank(answer) < _rank(best)):
            best = answer
            yield answer
        if not mends and float(np.abs(change).max()) < SETTLED:
            break
    if best is None:
        yield answer


def _changed(at: Configuration, change: Floats) -> Configuration:
    body = at.body
    joints = np.clip(at.joints + change[: body.count], body.lower + MARGIN, body.upper - MARGIN)
    x, y, turn = change[body.count :].tolist()
    chair = PlanarPose(at.chair.x + x, at.chair.y + y, wrapped(at.chair.theta + turn))
    return Configuration(body, joints, chair)


def _measured(at: Configuration, home: PlanarPose, goal: Floats) -> StandOff:
    error = pose_error(at.hand, goal)
    return StandOff(
        at,
        hypot(at.chair.x - home.x, at.chair.y - home.y),
        wrapped(at.chair.theta - home.theta),
        (float(np.linalg.norm(error[:3])), float(np.linalg.norm(error[3:]))),
    )


def _change(at: Configuration, home: PlanarPose, goal: Floats, may_drive: bool) -> Floats:
    """Give one damped step, (n + 3,): joints, and the chair's x, y, theta."""
    body = at.body
    count = body.count
    rows = _free_chair_jacobian(at)
    rows[3:] *= RADIAN
    error = pose_error(at.hand, goal)
    error[3:] *= RADIAN
    homeward = np.zeros(count + 3)
    homeward[count:] = (
        home.x - at.chair.x,
        home.y - at.chair.y,
        wrapped(home.theta - at.chair.theta),
    )
    free = np.ones(count + 3)
    if not may_drive:
        free[count:] = 0.0
    for _ in range(count):
        columns = rows * free
        square = columns @ rows.T
        square.flat[:: 6 + 1] += 1e-8 + 0.01 * float(error @ error)
        inverse = np.linalg.solve(square, np.column_stack((error, rows @ (free * homeward))))
        step: Floats = inverse[:, 0] @ columns + 0.3 * (free * homeward - inverse[:, 1] @ columns)
        after = at.joints + step[:count]
        low, high = body.lower + MARGIN, body.upper - MARGIN
        stuck = ((at.joints <= low) & (after < low)) | ((at.joints >= high) & (after > high))
        stuck &= free[:count] > 0.0
        if not stuck.any():
            break
        free[:count][stuck] = 0.0
    return step


def _free_chair_jacobian(at: Configuration) -> Floats:
    """Give the hand's twist per joint, and per x, y, heading of a chair that goes anywhere."""
    count = at.body.count
    rows = np.zeros((6, count + 3))
    rows[:, :count] = at.jacobian[:, :count]
    rows[0, count] = rows[1, count + 1] = rows[5, count + 2] = 1.0
    rows[0, count + 2] = -(at.hand[1, 3] - at.chair.y)
    rows[1, count + 2] = at.hand[0, 3] - at.chair.x
    return rows


def in_words(pose: PlanarPose) -> str:
    """Say a pose of the chair."""
    return f"x {pose.x:.2f} m, y {pose.y:.2f} m, heading {degrees(pose.theta):.0f} deg"
