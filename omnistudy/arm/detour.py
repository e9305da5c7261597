"""From one posture to another round the zones: two random trees that grow towards each other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.configuration import ArmBody
from omnistudy.seeds import generator

Floats = NDArray[np.float64]

SEED = "arm"
"""The same way at every run."""

GROWTHS = 400
"""Branches tried before giving up; ours."""

REACH, LOOK = 0.4, 0.01
"""rad, of the joint that moves most: length of a branch, and between two looks along it; ours."""

STRIDES = (16, 4, 1)
"""Looks along a branch at once, so that most of those that are not clear are found early."""

ROOM, SLACK = 0.005, 1e-4
"""m kept from every zone, but for postures that have less; and by how much it may be less."""

WIDER = 0.8
"""rad by which the box round both postures is widened for random ones; ours."""

SHORTCUTS = 60


def detour(body: ArmBody, start: Floats, goal: Floats) -> tuple[Floats, ...]:
    """Give postures from start to goal, straight in between and clear of zones; empty for none.

    RRT-Connect (Kuffner and LaValle 2000), then shortened. Straight when nothing is in between.
    """
    if _room(body, goal) <= 0.0:
        return ()
    if _clear(body, start, goal):
        return (start, goal)
    draw = generator(SEED, "detour")
    low = np.maximum(np.minimum(start, goal) - WIDER, body.lower)
    high = np.minimum(np.maximum(start, goal) + WIDER, body.upper)
    here, there = _Tree(start), _Tree(goal)
    for _ in range(GROWTHS):
        reached = here.grow(body, draw.uniform(low, high))
        met = None if reached is None else there.connect(body, here.nodes[reached])
        if reached is not None and met is not None:
            way = [*here.back(reached)[::-1], *there.back(met)[1:]]
            if way[0] is not start:
                way.reverse()
            return _shortened(body, way, draw)
        here, there = there, here
    return ()


class _Tree:
    def __init__(self, root: Floats) -> None:
        self.nodes = [root]
        self._before = [0]

    def grow(self, body: ArmBody, towards: Floats, *, vetted: bool = False) -> int | None:
        """Add a branch from the nearest node, at most `REACH` long; None where it is not clear.

        vetted : whether a node of a tree is there, which need not be looked at again.
        """
        nearest = int(np.abs(np.array(self.nodes) - towards).max(axis=1).argmin())
        begin = self.nodes[nearest]
        way = towards - begin
        longest = float(np.abs(way).max())
        end = towards if longest <= REACH else begin + way * (REACH / longest)
        known = end is towards and vetted
        if not (known or _room(body, end) >= ROOM) or not _clear(body, begin, end):
            return None
        self.nodes.append(end)
        self._before.append(nearest)
        return len(self.nodes) - 1

    def connect(self, body: ArmBody, towards: Floats) -> int | None:
        """Grow until it is there; None where it is stopped."""
        while True:
            reached = self.grow(body, towards, vetted=True)
            if reached is None or self.nodes[reached] is towards:
                return reached

    def back(self, node: int) -> list[Floats]:
        """Give the nodes from one back to the root."""
        way = [self.nodes[node]]
        while node != 0:
            node = self._before[node]
            way.append(self.nodes[node])
        return way


def _clear(body: ArmBody, begin: Floats, end: Floats) -> bool:
    """Whether the straight way between two postures is clear, as far as they are themselves."""
    needed = min(ROOM, _room(body, begin), _room(body, end)) - SLACK
    looks = max(1, int(np.ceil(np.abs(end - begin).max() / LOOK)))
    return all(
        _room(body, begin + look / looks * (end - begin)) >= needed
        for stride in STRIDES
        for look in range(stride, looks, stride)
    )


def _room(body: ArmBody, joints: Floats) -> float:
    """Give m to the nearest zone, `ROOM` at most."""
    rooms = body.clearances.near(body.frames(joints), ROOM).rooms
    return float(rooms.min()) if rooms.size else ROOM


def _shortened(body: ArmBody, way: list[Floats], draw: np.random.Generator) -> tuple[Floats, ...]:
    for _ in range(SHORTCUTS):
        if len(way) < 3:
            break
        first, last = sorted(draw.choice(len(way), 2, replace=False).tolist())
        if last - first > 1 and _clear(body, way[first], way[last]):
            way = [*way[: first + 1], *way[last:]]
    return tuple(way)
