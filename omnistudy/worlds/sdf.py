"""Worlds of Gazebo (SDF): boxes, cylinders, planes and actors, with a start, goal and way."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import radians
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from pydantic import ValidationError

from omnistudy.errors.worlds import BrokenSdf
from omnistudy.geometry import PlanarPose
from omnistudy.scene import Body, Box, Cylinder
from omnistudy.worlds.goal import goal_block, way_to
from omnistudy.worlds.route import Point
from omnistudy.worlds.sdf_actor import actors
from omnistudy.worlds.sdf_numbers import numbers
from omnistudy.worlds.world import Start, World

TILT = 1e-3
"""rad of roll or pitch up to which a body counts as upright."""


class Imported(NamedTuple):
    """A world, and what of the file was left out (included models, meshes), a line each."""

    world: World
    left_out: tuple[str, ...]


class Placed(NamedTuple):
    """Where a frame of the file stands: on the floor, and how high, m."""

    pose: PlanarPose
    z: float


FLOOR = Placed(PlanarPose(0.0, 0.0, 0.0), 0.0)
"""Where the world's own frame stands."""


def import_sdf(
    file: Path, start: PlanarPose, goal: Point, path: Sequence[Point] = (), name: str = ""
) -> Imported:
    """Read an SDF world; its bodies become walls, the goal a finish block that stops nothing.

    path : points in m between start and goal; none is a straight way. The `<state>` of a saved
    world is left alone. Raises BrokenSdf, which says what is wrong where, or NoWay.
    """
    route = way_to(start, path, goal)
    world = _world(file)
    left_out = _included(world)
    bodies = [
        body for model in world.findall("model") for body in _model(file, model, FLOOR, left_out)
    ]
    bodies += actors(file, world, left_out)
    title = f"{name or file.stem}, imported from {file.name}"
    try:
        made = World(
            name=name or file.stem,
            title=title,
            start=Start(x=start.x, y=start.y, theta=start.theta),
            bodies=(*bodies, goal_block(goal)),
            routes=(route,),
        )
    except ValidationError as fault:
        message = str(fault.errors()[0]["msg"]).removeprefix("Value error, ")
        raise BrokenSdf(file, message) from fault
    return Imported(made, tuple(left_out))


def _world(file: Path) -> ElementTree.Element:
    try:
        root = ElementTree.parse(file).getroot()
    except FileNotFoundError:
        raise BrokenSdf(file, "there is no such file") from None
    except (OSError, LookupError, ValueError, ElementTree.ParseError) as cause:
        raise BrokenSdf(file, f"it cannot be read as XML ({cause})") from cause
    world = root if root.tag == "world" else root.find("world")
    if root.tag not in ("sdf", "world") or world is None:
        raise BrokenSdf(file, "it holds no <sdf> with a <world>")
    return world


def _included(element: ElementTree.Element) -> list[str]:
    return [
        f"included model {include.findtext('uri', 'without uri').strip()}"
        for include in element.findall("include")
    ]


def _model(
    file: Path, model: ElementTree.Element, parent: Placed, left_out: list[str], within: str = ""
) -> Iterator[Body]:
    """Give a body for every collision of a model, and of the models in it, that is no floor."""
    name = within + (model.get("name") or "unnamed")
    at_model = _placed(file, name, model, parent)
    shapes = [
        (_placed(file, name, collision, _placed(file, name, link, at_model)), shape)
        for link in model.findall("link")
        for collision in link.findall("collision")
        for shape in collision.findall("geometry/*")
    ]
    solid = [(at, shape) for at, shape in shapes if not _is_floor(file, name, shape)]
    for number, (at, shape) in enumerate(solid, start=1):
        geometry = _geometry(file, name, shape)
        if geometry is None:
            left_out.append(f"the {shape.tag} of model '{name}'")
            continue
        yield Body(
            name=name if len(solid) == 1 else f"{name}_{number}",
            role="wall",
            geometry=geometry,
            x=at.pose.x,
            y=at.pose.y,
            z=at.z,
            yaw=at.pose.theta,
        )
    left_out += _included(model)
    for inner in model.findall("model"):
        yield from _model(file, inner, at_model, left_out, f"{name}::")


def _is_floor(file: Path, name: str, shape: ElementTree.Element) -> bool:
    """Tell whether a shape is a plane that faces up; any other plane is no floor to drive on."""
    if shape.tag != "plane":
        return False
    text = shape.findtext("normal", "0 0 1")
    x, y, z = numbers(file, f"the plane of model '{name}'", text, 3)
    return z > 0.0 and max(abs(x), abs(y)) <= TILT * z


def _placed(file: Path, name: str, element: ElementTree.Element, parent: Placed) -> Placed:
    """Compose an element's `<pose>` with its parent's."""
    pose = element.find("pose")
    if pose is None:
        return parent
    frame = pose.get("relative_to") or pose.get("frame")
    if frame:
        fault = f"model '{name}' has a pose relative to '{frame}', not to what it is part of"
        raise BrokenSdf(file, fault)
    text = pose.text or ""
    if not text.strip():
        return parent
    x, y, z, *turns = numbers(file, f"the pose of model '{name}'", text, 6)
    if pose.get("degrees") in ("true", "1"):
        turns = [radians(turn) for turn in turns]
    roll, pitch, yaw = turns
    if abs(roll) > TILT or abs(pitch) > TILT:
        raise BrokenSdf(file, f"model '{name}' is tilted; only upright bodies can be read")
    at_x, at_y = parent.pose.to_world(x, y)
    return Placed(PlanarPose(at_x, at_y, parent.pose.theta + yaw), parent.z + z)


def _geometry(file: Path, name: str, shape: ElementTree.Element) -> Box | Cylinder | None:
    if shape.tag not in ("box", "cylinder"):
        return None
    try:
        if shape.tag == "box":
            x, y, z = numbers(file, f"the box of model '{name}'", shape.findtext("size", ""), 3)
            return Box(x=x, y=y, z=z)
        radius, length = (
            numbers(file, f"the {part} of model '{name}'", shape.findtext(part, ""), 1)[0]
            for part in ("radius", "length")
        )
        return Cylinder(radius=radius, length=length)
    except ValidationError:
        raise BrokenSdf(file, f"the {shape.tag} of model '{name}' has no size") from None
