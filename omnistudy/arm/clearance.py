"""How far points of an arm are from the zones they must not enter, and what changes that."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.zones import Span, Zone

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]

NOTHING_NEAR: Numbers = np.zeros(0, dtype=np.intp)


class Clearance(NamedTuple):
    """Zones that are near.

    zones : (m,) which zones of the profile, by their place in its list.
    rooms : (m,) m to the face that the point is furthest in front of; negative inside the zone.
    slopes : (m, n) m by which each room grows per rad of each joint.
    """

    zones: Numbers
    rooms: Floats
    slopes: Floats


class ClearanceFinder:
    """The faces of all zones laid out as arrays; what zones are made of stands in `Zone`.

    A point outside a box is in front of at least one of its faces: the one with the most room is
    the plane that it must not cross. So a box, which cannot be a linear bound, becomes one.
    """

    def __init__(self, zones: tuple[Zone, ...], arm_height: float, joints: int) -> None:
        faces = [(z, *face) for z, zone in enumerate(zones) for face in _faces(zone, arm_height)]
        of = [zones[face[0]] for face in faces]
        self._frames = sorted({z.seen_from_joint - 1 for z in of if z.seen_from == "joint"})
        group = [
            1 + self._frames.index(z.seen_from_joint - 1) if z.seen_from == "joint" else 0
            for z in of
        ]
        self._joints = joints
        self._zone = np.array([face[0] for face in faces], dtype=np.intp)
        self._axis = np.array(
            [3 * g + face[1] for g, face in zip(group, faces, strict=True)], dtype=np.intp
        )
        self._next = np.array(
            [3 * g + (face[1] + 1) % 3 for g, face in zip(group, faces, strict=True)], np.intp
        )
        self._last = np.array(
            [3 * g + (face[1] + 2) % 3 for g, face in zip(group, faces, strict=True)], np.intp
        )
        self._sign = np.array([face[2] for face in faces])
        self._offset = np.array([face[2] * face[3] for face in faces])
        self._point = np.array([z.joint - 1 for z in of], dtype=np.intp)
        first = [0 if z.seen_from != "joint" else z.seen_from_joint for z in of]
        columns = np.arange(joints)
        moves = (columns >= np.array(first)[:, None]) & (columns < self._point[:, None] + 1)
        self._moves = self._sign[:, None] * moves if faces else np.zeros((0, joints))
        self._starts = np.flatnonzero(np.diff(self._zone, prepend=-1))
        self._zones = self._zone[self._starts]
        self._ends = np.append(self._starts[1:], len(faces))

    def near(self, frames: Floats, within: float) -> Clearance:
        """Find what is nearer than `within` m, for frames (n, 4, 4) seen from the arm's base."""
        if not len(self._zone):
            return Clearance(NOTHING_NEAR, np.zeros(0), np.zeros((0, self._joints)))
        columns = frames[:, :3, 2:].T
        axes, places = columns[0], columns[1]
        for index in self._frames:
            turned = frames[index, :3, :3].T
            axes = np.concatenate((axes, turned @ columns[0]))
            seen = turned @ (columns[1] - frames[index, :3, 3:])
            places = np.concatenate((places, seen))
        rooms = self._sign * places[self._axis, self._point] - self._offset
        nearest = np.maximum.reduceat(rooms, self._starts)
        found = np.flatnonzero(nearest < within)
        if not found.size:
            return Clearance(NOTHING_NEAR, np.zeros(0), np.zeros((0, self._joints)))
        starts, ends = self._starts.tolist(), self._ends.tolist()
        faces = np.array(
            [starts[i] + int(rooms[starts[i] : ends[i]].argmax()) for i in found.tolist()],
            dtype=np.intp,
        )
        one, two, point = self._next[faces], self._last[faces], self._point[faces]
        slopes = axes[one] * (places[two, point][:, None] - places[two])
        slopes -= axes[two] * (places[one, point][:, None] - places[one])
        slopes *= self._moves[faces]
        return Clearance(self._zones[found], nearest[found], slopes)


def _faces(zone: Zone, arm_height: float) -> list[tuple[int, float, float]]:
    """Give each face that is not at infinity: its axis, the side that is free, where it stands."""
    raised = (0.0, 0.0, arm_height if zone.seen_from == "floor" else 0.0)
    spans: tuple[Span, ...] = (zone.x, zone.y, zone.z)
    faces = []
    for axis, (low, high) in enumerate(spans):
        if low is not None:
            faces.append((axis, -1.0, low - raised[axis]))
        if high is not None:
            faces.append((axis, 1.0, high - raised[axis]))
    return faces
