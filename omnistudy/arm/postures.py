"""Which joints bring the hand to a pose, as the arm's base sees it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.configuration import ArmBody
from omnistudy.geometry.rigid_motion import pose_error

Floats = NDArray[np.float64]

RADIAN = 0.5
"""m that a radian counts as."""

SEARCH_STEPS = 60
FURTHEST_STEP = 0.4
"""rad, most that a joint changes in one step of the search."""

NEAR_ENOUGH = 1e-6
"""m, a radian counted as `RADIAN`."""

MARGIN = 0.002
"""rad kept from the joints' limits."""

ROOM, LEAST_ROOM = 0.015, 0.0015
"""m to a zone that is sought, and with which an answer is content; ours."""

PUSH = 15.0
"""rad per m^2, away from a zone in one step; ours."""

ALIKE = 0.2
"""rad: answers nearer than this to each other are the same."""

SPREAD = ((0, 0.6), (0, -0.6), (2, 0.8), (2, -0.8), (4, 1.2), (4, -1.2))
"""Joint (from 0) and rad by which the ready posture is changed to begin elsewhere; ours."""


def postures(body: ArmBody, hand: Floats, near: Floats) -> Iterator[Floats]:
    """Give joints (n,) that bring the hand to a pose (4, 4) seen from the arm's base.

    Limits are kept and no zone is entered. The search begins at the joints `near`; what is found
    depends on where it begins, so that none may be found though there are some.
    """
    found: list[Floats] = []
    for begin in _begins(body, near):
        joints = _search(body, hand, begin)
        if joints is not None and all(np.abs(joints - other).max() > ALIKE for other in found):
            found.append(joints)
            yield joints


def _begins(body: ArmBody, near: Floats) -> Iterator[Floats]:
    """Begin at `near`, at the ready posture, its mirror image, and some between and around."""
    ready = np.array(body.profile.ready)
    mirrored = ready * np.array([1.0 if i % 2 else -1.0 for i in range(body.count)])
    middle = 0.5 * (body.lower + body.upper)
    yield from (near, ready, mirrored, 0.5 * (ready + middle))
    for joint, change in SPREAD:
        other = ready.copy()
        other[joint] += change
        yield other


def _search(body: ArmBody, hand: Floats, begin: Floats) -> Floats | None:
    """Go down to the pose by damped steps, and in the freedom left away from the zones.

    Joints at their limits rest.
    """
    low, high = body.lower + MARGIN, body.upper - MARGIN
    joints = np.clip(begin, low, high)
    for _ in range(SEARCH_STEPS):
        frames = body.frames(joints)
        error = pose_error(frames[-1], hand)
        error[3:] *= RADIAN
        left = float(error @ error)
        near = body.clearances.near(frames, ROOM)
        if left < NEAR_ENOUGH * NEAR_ENOUGH and (near.rooms > LEAST_ROOM).all():
            return joints
        rows = body.jacobian(frames)
        rows[3:] *= RADIAN
        aside = PUSH * ((ROOM - near.rooms) @ near.slopes)
        change = _step(rows, error, aside, (joints <= low, joints >= high))
        joints = np.clip(joints + change, low, high)
    return None


def _step(
    rows: Floats,
    error: Floats,
    aside: Floats,
    at_ends: tuple[NDArray[np.bool_], NDArray[np.bool_]],
) -> Floats:
    free = np.ones(rows.shape[1])
    for _ in range(len(free)):
        columns = rows * free
        square = columns @ rows.T
        square.flat[:: len(square) + 1] += 1e-9 + 0.01 * float(error @ error)
        freed = aside * free
        change: Floats = freed + np.linalg.solve(square, error - rows @ freed) @ columns
        stuck = ((at_ends[0] & (change < 0.0)) | (at_ends[1] & (change > 0.0))) & (free > 0.0)
        if not stuck.any():
            break
        free[stuck] = 0.0
    return change / max(1.0, float(np.abs(change).max()) / FURTHEST_STEP)
