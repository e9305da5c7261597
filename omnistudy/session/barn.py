"""Worlds of the BARN navigation benchmark, each with its reference path as the route."""

from __future__ import annotations

from pathlib import Path

from omnistudy.errors.drive import NotABarnFolder
from omnistudy.geometry import PlanarPose
from omnistudy.worlds import World
from omnistudy.worlds.path_file import read_path
from omnistudy.worlds.route import Point
from omnistudy.worlds.sdf import import_sdf

START = PlanarPose(-2.25, 3.0, 1.57)
GOAL: Point = (-2.25, 13.0)
"""Both the same in every world of the benchmark; the goal lies 10 m ahead of the start."""

CELL = 0.15
"""Side in m of the grid in which reference paths are written (twice a cylinder's radius)."""
FIRST_CELL: Point = (-4.575, 5.075)
"""Where cell (0, 0) lies, m."""


def barn_worlds(folder: Path) -> list[World]:
    """Read every world_N.world of a folder with its path_N.npy, in the order of N.

    Raises NotABarnFolder, BrokenSdf or BrokenPath.
    """
    files = [file for file in folder.glob("world_*.world") if _number(file).isdigit()]
    if not files:
        raise NotABarnFolder(folder)
    return [barn_world(file) for file in sorted(files, key=lambda file: int(_number(file)))]


def barn_world(file: Path) -> World:
    """Read one world and its path: from BARN's start to the path, along it, and to the goal.

    Raises BrokenSdf or BrokenPath.
    """
    way = read_path(file.with_name(f"path_{_number(file)}.npy"), CELL, FIRST_CELL)
    return import_sdf(file, START, GOAL, way, name=f"barn_{_number(file)}").world


def _number(file: Path) -> str:
    return file.stem.removeprefix("world_")
