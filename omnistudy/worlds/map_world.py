"""A map of ROS's map_server as a world."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from math import cos, sin
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.worlds import NoFreeSpace, TooManyBoxes
from omnistudy.geometry import PlanarPose
from omnistudy.worlds.goal import goal_block, way_to
from omnistudy.worlds.grid import Grid
from omnistudy.worlds.map_server import FREE, OCCUPIED, UNKNOWN, MapPage, read_map
from omnistudy.worlds.rectangles import rectangles
from omnistudy.worlds.route import Point
from omnistudy.worlds.world import Start, World

MOST_BOXES = 20_000
"""Boxes that a map may need (ours); with so many, physics is about four times as fast as life."""


class ImportedMap(NamedTuple):
    """A world, and what became of the map's cells.

    columns, rows : size of the map in cells. occupied, unknown : numbers of such cells.
    partly : cells of modes `scale` and `raw` between free and occupied.
    """

    world: World
    columns: int
    rows: int
    occupied: int
    unknown: int
    partly: int


def import_map(
    file: Path,
    start: PlanarPose | None = None,
    goal: Point | None = None,
    path: Sequence[Point] = (),
    name: str = "",
) -> ImportedMap:
    """Read a map; its occupied cells become boxes, all others stay open.

    Unknown cells stay open because a map says nothing of them: SLAM leaves them behind walls, and
    as specks in the free floor. Partly occupied cells are no obstacle for nav2's costmap either.

    start : None puts the robot where it is furthest from anything occupied.
    goal : None makes a world without a route. path : points in m between start and goal.

    Raises BrokenMap, NoFreeSpace, TooManyBoxes or NoWay.
    """
    page, cells = read_map(file)
    solid = cells == OCCUPIED
    unknown = int((cells == UNKNOWN).sum())
    if not (free := cells == FREE).any():
        raise NoFreeSpace(file, int(solid.sum()), unknown)
    blocks = tuple(islice(rectangles(solid), MOST_BOXES + 1))
    if len(blocks) > MOST_BOXES:
        raise TooManyBoxes(file, MOST_BOXES)
    x, y, yaw = page.origin
    grid = Grid(resolution=page.resolution, x=x, y=y, theta=yaw, blocks=blocks)
    begin = start or _widest(page, solid, free)
    world = World(
        name=name or file.stem,
        title=f"{name or file.stem}, imported from {file.name}",
        start=Start(x=begin.x, y=begin.y, theta=begin.theta),
        grid=grid,
        bodies=() if goal is None else (goal_block(goal),),
        routes=() if goal is None else (way_to(begin, path, goal),),
    )
    rows, columns = cells.shape
    partly = int(((cells > FREE) & (cells < OCCUPIED)).sum())
    return ImportedMap(world, columns, rows, int(solid.sum()), unknown, partly)


def _widest(page: MapPage, solid: NDArray[np.bool_], free: NDArray[np.bool_]) -> PlanarPose:
    """Give the middle of the free cell that is furthest from occupied cells."""
    from scipy.ndimage import distance_transform_edt

    distances = np.where(free, distance_transform_edt(np.pad(~solid, 1))[1:-1, 1:-1], -1.0)
    row, column = np.unravel_index(int(distances.argmax()), distances.shape)
    x, y, yaw = page.origin
    along, up = (float(index + 0.5) * page.resolution for index in (column, row))
    c, s = cos(yaw), sin(yaw)
    return PlanarPose(x + c * along - s * up, y + s * along + c * up, yaw)
