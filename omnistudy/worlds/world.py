"""A world: walls, blocks, door, named regions, a start and the routes through it."""

from __future__ import annotations

from collections import Counter
from functools import cached_property
from typing import Literal, Self

from pydantic import model_validator

from omnistudy.errors.worlds import NoRoute, UnknownRoute
from omnistudy.geometry import PlanarPose
from omnistudy.registry import KindModel, Model
from omnistudy.scene import Body, Region, Scene
from omnistudy.units import Metres, Radians
from omnistudy.worlds.grid import Grid
from omnistudy.worlds.route import Route
from omnistudy.worlds.walls import Walls


class Start(Model):
    """Where the robot stands when a trial opens."""

    x: Metres
    y: Metres
    theta: Radians = 0.0

    @property
    def pose(self) -> PlanarPose:
        """The same as a pose."""
        return PlanarPose(self.x, self.y, self.theta)


class World(KindModel):
    """A world as data (Tyagi 2017, ch. 4, Fig. 4.10-4.12); lengths in m, angles in rad."""

    kind: Literal["plan"] = "plan"
    name: str
    title: str = ""
    start: Start
    walls: Walls = Walls()
    grid: Grid | None = None
    """Solid cells of a map."""
    bodies: tuple[Body, ...] = ()
    """Blocks, doors, finish, and walls that are not straight lines of the common make."""
    regions: tuple[Region, ...] = ()
    routes: tuple[Route, ...] = ()
    """None: nobody can drive through it yet, as when it comes from a map."""

    @model_validator(mode="after")
    def _names_differ(self) -> Self:
        for what, names in (
            ("bodies or walls", [body.name for body in self.scene.bodies]),
            ("routes", [route.name for route in self.routes]),
            ("regions", [region.name for region in self.regions]),
        ):
            twice = sorted(name for name, times in Counter(names).items() if times > 1)
            if twice:
                raise ValueError(f"two {what} have the name '{twice[0]}': every name must differ")
        return self

    @cached_property
    def scene(self) -> Scene:
        """What stands in this world: walls, then cells of a map, then bodies, in their order."""
        cells = self.grid.bodies if self.grid else ()
        return Scene(bodies=self.walls.bodies + cells + self.bodies, regions=self.regions)

    @property
    def first_route(self) -> Route:
        """The route that is driven when none is named; raises NoRoute."""
        if not self.routes:
            raise NoRoute(self.name)
        return self.routes[0]

    def route(self, name: str) -> Route:
        """Give a route by name; raises UnknownRoute or NoRoute."""
        if not self.routes:
            raise NoRoute(self.name)
        for route in self.routes:
            if route.name == name:
                return route
        raise UnknownRoute(self.name, name, [route.name for route in self.routes])
