"""What a robot looks like: links that hang on each other, moved by channels that it records."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from omnistudy.registry.model import Model
from omnistudy.scene.scene import Box, Colour, Cylinder
from omnistudy.units import Metres, Radians

Axis = tuple[float, float, float]

Surface = Literal["plain", "rollers_left", "rollers_right"]
"""What covers a link; the rollers of a mecanum wheel slant to the left or to the right."""


class Joint(Model):
    """How a link moves against its parent: a recorded channel about or along an axis."""

    channel: str
    """Name of the channel, in rad or m (rad/s or m/s where it is a rate)."""
    axis: Axis = (0.0, 0.0, 1.0)
    """Direction in the link's own frame."""
    motion: Literal["turn", "slide"] = "turn"
    rate: bool = False
    """True: the channel is a speed, and what it has added up to since the start counts."""


class Link(Model):
    """One rigid piece of a robot; its pose is that of the middle of its shape, in its parent."""

    name: str
    parent: str = ""
    """Name of the link that it hangs on; empty for the robot's own frame, on the floor."""
    geometry: Annotated[Box | Cylinder, Field(discriminator="shape")]
    x: Metres = 0.0
    y: Metres = 0.0
    z: Metres = 0.0
    roll: Radians = 0.0
    pitch: Radians = 0.0
    yaw: Radians = 0.0
    colour: Colour = "#8a8f98"
    surface: Surface = "plain"
    joint: Joint | None = None
