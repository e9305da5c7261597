"""Boxes in which points of the arm would touch the user, the chair, the floor or the arm itself."""

from __future__ import annotations

from typing import Annotated, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from omnistudy.registry import Model
from omnistudy.units import Metres

Floats = NDArray[np.float64]
Span = tuple[Metres | None, Metres | None]
"""Lowest and highest, m; None is without end."""

ANYWHERE: Span = (None, None)


class Zone(Model):
    """A box, in axes of the wheelchair, that the origin of one joint's frame must not enter."""

    name: str
    guards: Literal["user", "chair", "floor", "self"]
    joint: Annotated[int, Field(ge=1)]
    """Whose frame's origin is watched; the last joint's is the hand."""
    seen_from: Literal["arm_base", "floor", "joint"] = "arm_base"
    """Where the box stands: the arm's base, the floor below it, or another joint's frame."""
    seen_from_joint: Annotated[int, Field(ge=0)] = 0
    """That other joint."""
    x: Span = ANYWHERE
    y: Span = ANYWHERE
    z: Span = ANYWHERE


def _zone(name: str, guards: Literal["user", "chair"], joint: int, *spans: Span) -> Zone:
    x, y, z = spans
    return Zone(name=name, guards=guards, joint=joint, x=x, y=y, z=z)


LAB_ZONES: tuple[Zone, ...] = (
    *(
        Zone(name="floor", guards="floor", joint=joint, seen_from="floor", z=(None, 0.100))
        for joint in (3, 4, 5, 7)
    ),
    _zone("front left side", "chair", 3, (0.450, None), (None, -0.150), ANYWHERE),
    _zone("rear left side", "chair", 3, (None, 0.450), (None, 0.100), ANYWHERE),
    _zone("left side", "chair", 4, (-0.100, 0.450), (None, 0.0), ANYWHERE),
    _zone("rear left side", "chair", 4, (None, -0.100), (None, 0.100), ANYWHERE),
    _zone("shoulder", "user", 5, (-0.550, -0.100), (None, 0.150), ANYWHERE),
    _zone("lap", "user", 5, (-0.100, 0.400), (None, 0.0), (None, 0.470)),
    _zone("battery", "chair", 5, (-0.630, -0.430), (None, 0.100), (None, 0.050)),
    _zone("shoulder", "user", 7, (-0.600, -0.050), (None, 0.200), ANYWHERE),
    _zone("lap", "user", 7, (-0.050, 0.450), (None, 0.050), (None, 0.520)),
    _zone("battery", "chair", 7, (-0.680, -0.480), (None, 0.050), (None, 0.100)),
    Zone(
        name="upper arm",
        guards="self",
        joint=7,
        seen_from="joint",
        seen_from_joint=3,
        x=(-0.170, 0.170),
        y=(-0.100, None),
        z=(None, 0.0),
    ),
)
"""The lab's own, from the program behind the thesis (WMRA_collide). The names are
ours but for the user's, the battery and "rear left side". A third box of joint 3 lies inside that
one and is left out."""


class Intrusions(NamedTuple):
    """Which zones are entered.

    names : each once. depths : (zones,) how far a point lies inside each, m; 0 outside.
    """

    names: tuple[str, ...]
    depths: Floats

    def deeper_than(self, other: Intrusions) -> bool:
        """Whether any zone is entered deeper than before."""
        return bool((self.depths > other.depths).any())


class ZoneChecker:
    """Zones laid out as arrays, for one arm's base height."""

    def __init__(self, zones: tuple[Zone, ...], arm_height: float) -> None:
        self._names = tuple(zone.name for zone in zones)
        self._none = Intrusions((), np.zeros(len(zones)))
        self._joints = np.array([zone.joint - 1 for zone in zones], dtype=np.intp)
        self._seen_from_joints = [
            (index, zone.seen_from_joint - 1)
            for index, zone in enumerate(zones)
            if zone.seen_from == "joint"
        ]
        raised = np.array([arm_height if z.seen_from == "floor" else 0.0 for z in zones])
        bounds = np.array([[_ends(span) for span in (z.x, z.y, z.z)] for z in zones])
        bounds = bounds.reshape(-1, 3, 2)
        bounds[:, 2, :] -= raised[:, None]
        self._low, self._high = bounds[:, :, 0].copy(), bounds[:, :, 1].copy()

    def intrusions(self, frames: Floats) -> Intrusions:
        """Find the zones entered by an arm whose joint frames, seen from its base, are given.

        frames : (n, 4, 4), as ArmBody.frames gives them.
        """
        if not self._names:
            return self._none
        points = frames[self._joints, :3, 3]
        for index, other in self._seen_from_joints:
            frame = frames[other]
            points[index] = (points[index] - frame[:3, 3]) @ frame[:3, :3]
        room = np.minimum(points - self._low, self._high - points).min(axis=1)
        if room.max() < 0.0:
            return self._none
        names = dict.fromkeys(self._names[index] for index in (room >= 0.0).nonzero()[0])
        return Intrusions(tuple(names), np.maximum(room, 0.0))


def _ends(span: Span) -> tuple[float, float]:
    low, high = span
    return (-np.inf if low is None else low, np.inf if high is None else high)
