"""What stands in a world, as values: plants turn them into physics, drawings into plans."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from omnistudy.registry.model import Model
from omnistudy.scene.motion import Motion, Track
from omnistudy.units import Kilograms, Metres, NewtonMetres, Positive, Radians

Role = Literal["wall", "target", "finish", "door", "floor"]
"""Only contact with a `wall` is a collision; `target` and `finish` are touched on purpose."""

Colour = Annotated[str, Field(pattern=r"^#[0-9a-fA-F]{6}$")]
"""As #rrggbb."""


HINGE = "hinge_"
"""Before the name of a body: the channel of its hinge's angle, rad."""


class Box(Model):
    """A box of full side lengths."""

    shape: Literal["box"] = "box"
    x: Annotated[Metres, Positive]
    y: Annotated[Metres, Positive]
    z: Annotated[Metres, Positive]


class Cylinder(Model):
    """An upright cylinder."""

    shape: Literal["cylinder"] = "cylinder"
    radius: Annotated[Metres, Positive]
    length: Annotated[Metres, Positive]


Shape = Annotated[Box | Cylinder, Field(discriminator="shape")]


class Hinge(Model):
    """An upright hinge that gives way: where it stands in the body's frame, and its friction."""

    x: Metres
    """Hinge axis in the body's own frame, ahead of its centre."""
    y: Metres = 0.0
    """Hinge axis in the body's own frame, left of its centre."""
    friction: Annotated[NewtonMetres, Field(ge=0)] = 1.0
    """Torque that must be overcome to turn it."""
    lower: Radians = -1.6
    upper: Radians = 1.6

    @model_validator(mode="after")
    def _turns(self) -> Self:
        if not self.lower < self.upper:
            raise ValueError("lower must be below upper")
        return self


class Body(Model):
    """One thing in a world; the pose is that of its centre."""

    name: str
    role: Role
    geometry: Shape
    x: Metres
    y: Metres
    z: Metres
    """Height of the centre above the floor."""
    yaw: Radians = 0.0
    colour: Colour = "#8a8f98"
    """For drawings and views."""
    solid: bool = True
    """False: noticed when touched, but stops nothing."""
    hinge: Hinge | None = None
    mass: Annotated[Kilograms, Field(ge=0)] = 0.0
    """Zero stands still; a body with a hinge needs a mass."""
    part_of: str = ""
    """Of what it is a part that is touched as one, such as a map of many boxes."""
    motion: Motion | None = None
    """A scripted path; (x, y) is where it begins. Nothing stops or pushes such a body."""

    @model_validator(mode="after")
    def _hinged_weighs(self) -> Self:
        if self.hinge is not None and self.mass == 0.0:
            raise ValueError("a body with a hinge needs a mass above 0 kg")
        return self

    @model_validator(mode="after")
    def _moves_as_a_wall(self) -> Self:
        if self.motion is None:
            return self
        if self.role != "wall" or not self.solid or self.hinge is not None:
            raise ValueError("a body with a motion must be a solid wall without a hinge")
        track = self.motion.track((self.x, self.y))
        if all(place == track.places[0] for place in track.places):
            raise ValueError("a motion must lead somewhere else than the body's own place")
        if track.jumps:
            raise ValueError(
                "a timetable that repeats must end at the body's own place "
                f"({self.x:g}, {self.y:g}): bodies do not jump"
            )
        return self

    @model_validator(mode="after")
    def _part_stands(self) -> Self:
        moves = self.hinge is not None or self.motion is not None
        box = isinstance(self.geometry, Box)
        if self.part_of and (moves or not box or self.role != "wall" or not self.solid):
            raise ValueError("a part must be a box, a wall, solid, and stand still")
        return self

    @property
    def blocks(self) -> bool:
        """Whether a robot can never pass where it stands: solid, no door, and not moving."""
        return self.solid and self.hinge is None and self.motion is None and self.role != "floor"

    @cached_property
    def track(self) -> Track | None:
        """Its scripted path laid out in time; None when it stays where it is."""
        return self.motion.track((self.x, self.y)) if self.motion else None


class Region(Model):
    """A named part of the floor, such as a primitive of the thesis, to cut trajectories by."""

    name: str
    polygon: Annotated[tuple[tuple[Metres, Metres], ...], Field(min_length=3)]
    group: str = ""
    """A larger data set that the region belongs to, such as "blue" or "green"."""

    def contains(self, x: float, y: float) -> bool:
        """Tell whether a point in m lies inside (even-odd rule)."""
        inside = False
        px, py = self.polygon[-1]
        for qx, qy in self.polygon:
            if (qy > y) != (py > y) and x < (px - qx) * (y - qy) / (py - qy) + qx:
                inside = not inside
            px, py = qx, qy
        return inside


class Scene(Model):
    """Everything that has a body, and the named regions of the floor."""

    bodies: tuple[Body, ...]
    regions: tuple[Region, ...] = ()

    @cached_property
    def moving(self) -> tuple[Body, ...]:
        """The bodies that follow a scripted path."""
        return tuple(body for body in self.bodies if body.motion)
