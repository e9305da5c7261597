"""Worlds and the routes through them, as data; importers; drawings and checks of plans."""

from omnistudy.worlds.find import load_world, world_file, world_names
from omnistudy.worlds.route import Leg, Route
from omnistudy.worlds.situation import Passing, Situation, passing
from omnistudy.worlds.walls import Wall, Walls
from omnistudy.worlds.world import Start, World

__all__ = [
    "Leg",
    "Passing",
    "Route",
    "Situation",
    "Start",
    "Wall",
    "Walls",
    "World",
    "load_world",
    "passing",
    "world_file",
    "world_names",
]
