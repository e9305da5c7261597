"""Small worlds and a whole trial for the tests of the inner rooms: a corner, a wall, a run."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import atan2, hypot, pi
from pathlib import Path
from typing import Any

import yaml

from omnistudy.channel import Recording
from omnistudy.controllers.rate import RateController
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.laws.none import NoLaw
from omnistudy.operators import Person
from omnistudy.operators.virtual_driver import VirtualDriver
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body, Box, Hinge, Scene
from omnistudy.tasks import Messages
from omnistudy.tasks.route import RouteTask
from omnistudy.trial.spec import TrialSpec
from omnistudy.worlds import Leg, Route, Start, World

MESSAGES_PAGE = Path(__file__).parent.parent / "conf" / "messages" / "en.yaml"
THICKNESS = 0.1


@cache
def messages() -> Messages:
    """What participants read, from the page that they really get."""
    return Messages.model_validate(yaml.safe_load(MESSAGES_PAGE.read_text(encoding="utf-8")))


def wall(name: str, start: tuple[float, float], end: tuple[float, float]) -> Body:
    """A wall 0.1 m thick whose centre line joins two points."""
    (ax, ay), (bx, by) = start, end
    return Body(
        name=name,
        role="wall",
        geometry=Box(x=hypot(bx - ax, by - ay), y=THICKNESS, z=0.8),
        x=(ax + bx) / 2,
        y=(ay + by) / 2,
        z=0.4,
        yaw=atan2(by - ay, bx - ax),
    )


def wall_ahead(distance: float, half_length: float = 2.0) -> Body:
    """A wall across the x axis whose near face is `distance` ahead of the origin."""
    middle = distance + THICKNESS / 2
    return wall("ahead", (middle, -half_length), (middle, half_length))


def wall_left(distance: float, half_length: float = 2.0) -> Body:
    """A wall along the x axis whose near face is `distance` left of the origin."""
    middle = distance + THICKNESS / 2
    return wall("left", (-half_length, middle), (half_length, middle))


def block(name: str, x: float, y: float, role: Any = "target") -> Body:
    """A low block that is noticed but stops nothing."""
    return Body(
        name=name,
        role=role,
        geometry=Box(x=0.15, y=0.15, z=0.1),
        x=x,
        y=y,
        z=0.05,
        solid=False,
    )


def door(x: float, width: float = 1.0) -> Body:
    """A door across the x axis, hinged at its left end."""
    return Body(
        name="door",
        role="door",
        geometry=Box(x=width, y=0.04, z=0.8),
        x=x,
        y=0.0,
        z=0.4,
        yaw=pi / 2,
        mass=5.0,
        hinge=Hinge(x=width / 2),
    )


def scene(*bodies: Body) -> Scene:
    return Scene(bodies=bodies)


def straight_world(length: float = 2.0, half_width: float = 0.5) -> World:
    """A corridor along x: a block at its end, back to the finish; 2·length of way."""
    return World(
        name="straight",
        start=Start(x=0.0, y=0.0),
        bodies=(
            wall("left", (-1.0, half_width + 0.05), (length + 1.0, half_width + 0.05)),
            wall("right", (-1.0, -half_width - 0.05), (length + 1.0, -half_width - 0.05)),
            block("red", length, 0.0),
        ),
        routes=(Route(name="there", legs=(Leg(target="red", path=((0, 0), (length, 0))),)),),
    )


def corner_world(mirrored: bool = False) -> World:
    """Along a corridor, round a corner to the left (or right, mirrored), to a block and on."""
    side = -1.0 if mirrored else 1.0

    def at(x: float, y: float) -> tuple[float, float]:
        return x, side * y

    walls = (
        wall("outer", at(-1, -0.55), at(3.55, -0.55)),
        wall("inner", at(-1, 0.55), at(2.45, 0.55)),
        wall("end", at(3.55, -0.55), at(3.55, 4)),
        wall("side", at(2.45, 0.55), at(2.45, 4)),
        wall("top", at(2.45, 4), at(3.55, 4)),
    )
    return World(
        name="corner",
        start=Start(x=0.0, y=0.0),
        bodies=(*walls, block("red", *at(3, 2)), block("finish", *at(3, 3.5), role="finish")),
        routes=(
            Route(
                name="round",
                legs=(
                    Leg(target="red", path=(at(0, 0), at(3, 0), at(3, 2))),
                    Leg(target="finish", path=(at(3, 2), at(3, 3.5))),
                ),
            ),
        ),
    )


def trial(world: World | None = None, seed: str = "a", **changes: Any) -> TrialSpec:
    """A whole trial round the corner without feedback; any part of it can be changed."""
    world = world or corner_world()
    spec = TrialSpec(
        world=world,
        route=world.routes[0].name,
        plant=Youbot(),
        device=SimulatedStick(),
        controller=RateController(),
        law=NoLaw(),
        operator=VirtualDriver(),
        task=RouteTask(),
        recording=Recording(),
        messages=messages(),
        person=Person(f"participant {seed}", f"trial {seed}", 1),
    )
    return replace(spec, **changes)
