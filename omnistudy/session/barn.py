"""Worlds of the BARN navigation benchmark, each with its reference path as the route."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from omnistudy.errors.drive import BrokenBarnFile, NotABarnFolder
from omnistudy.scene import Body, Box, Cylinder
from omnistudy.worlds import Leg, Route, Start, World
from omnistudy.worlds.route import Point

START = Start(x=-2.25, y=3.0, theta=1.57)
GOAL: Point = (-2.25, 13.0)
"""Both the same in every world of the benchmark; the goal lies 10 m ahead of the start."""

CELL = 0.15
"""Side in m of the grid in which reference paths are written (twice a cylinder's radius)."""
FIRST_CELL: Point = (-4.575, 5.075)
"""Where cell (0, 0) lies, m."""


def barn_worlds(folder: Path) -> list[World]:
    """Read every world_N.world of a folder with its path_N.npy, in the order of N.

    Raises NotABarnFolder or BrokenBarnFile.
    """
    files = [file for file in folder.glob("world_*.world") if _number(file).isdigit()]
    if not files:
        raise NotABarnFolder(folder)
    return [barn_world(file) for file in sorted(files, key=lambda file: int(_number(file)))]


def barn_world(file: Path) -> World:
    """Read one world and its path: from BARN's start to the path, along it, and to the goal.

    Raises BrokenBarnFile.
    """
    goal = Body(
        name="goal",
        role="finish",
        geometry=Box(x=0.15, y=0.15, z=0.1),
        x=GOAL[0],
        y=GOAL[1],
        z=0.05,
        colour="#2f6fd0",
        solid=False,
    )
    way = ((START.x, START.y), *_path(file.with_name(f"path_{_number(file)}.npy")), GOAL)
    return World(
        name=f"barn_{_number(file)}",
        title=f"BARN world {_number(file)}",
        start=START,
        bodies=(*_cylinders(file), goal),
        routes=(Route(name="reference", legs=(Leg(target="goal", path=way),)),),
    )


def _number(file: Path) -> str:
    return file.stem.removeprefix("world_")


def _path(file: Path) -> list[Point]:
    try:
        cells = np.load(file, allow_pickle=False)
    except FileNotFoundError:
        raise BrokenBarnFile(file, "there is no such file") from None
    except (OSError, ValueError, EOFError) as cause:
        raise BrokenBarnFile(file, f"it is no array of numpy ({cause})") from cause
    if cells.ndim != 2 or cells.shape[1] != 2 or len(cells) == 0:
        raise BrokenBarnFile(file, f"its shape is {cells.shape}, not (rows, 2)")
    return [(CELL * i + FIRST_CELL[0], CELL * j + FIRST_CELL[1]) for i, j in cells.tolist()]


def _cylinders(file: Path) -> list[Body]:
    """Read the upright cylinders of an SDF world; the ground plane is the floor."""
    try:
        models = ElementTree.parse(file).findall("world/model")
    except (OSError, ElementTree.ParseError) as cause:
        raise BrokenBarnFile(file, f"it is no SDF world ({cause})") from cause
    bodies = []
    for model in models:
        shape = model.find("link/collision/geometry/*")
        if shape is None or shape.tag == "plane":
            continue
        if shape.tag != "cylinder":
            raise BrokenBarnFile(file, f"model '{model.get('name')}' is a {shape.tag}")
        try:
            bodies.append(_cylinder(model, shape))
        except ValueError:
            fault = f"model '{model.get('name')}' lacks a pose, a radius or a length"
            raise BrokenBarnFile(file, fault) from None
    return bodies


def _cylinder(model: ElementTree.Element, shape: ElementTree.Element) -> Body:
    x, y, z = (float(number) for number in model.findtext("pose", "").split()[:3])
    return Body(
        name=str(model.get("name")),
        role="wall",
        geometry=Cylinder(
            radius=float(shape.findtext("radius", "")),
            length=float(shape.findtext("length", "")),
        ),
        x=x,
        y=y,
        z=z,
    )
