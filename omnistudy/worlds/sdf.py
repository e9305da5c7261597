"""Worlds of Gazebo (SDF): boxes, cylinders and planes, with a start, a goal and a way."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from pydantic import ValidationError

from omnistudy.errors.worlds import BrokenSdf
from omnistudy.geometry import PlanarPose
from omnistudy.scene import Body, Box, Cylinder
from omnistudy.worlds.route import Leg, Point, Route
from omnistudy.worlds.world import Start, World

TILT = 1e-3
"""rad of roll or pitch up to which a body counts as upright."""
GOAL = Box(x=0.15, y=0.15, z=0.1)


class Imported(NamedTuple):
    """A world, and what of the file was left out (included models, meshes), a line each."""

    world: World
    left_out: tuple[str, ...]


class Placed(NamedTuple):
    """Where a frame of the file stands: on the floor, and how high, m."""

    pose: PlanarPose
    z: float


def import_sdf(
    file: Path, start: PlanarPose, goal: Point, path: Sequence[Point] = (), name: str = ""
) -> Imported:
    """Read an SDF world; its bodies become walls, the goal a finish block that stops nothing.

    path : points in m between start and goal; none is a straight way. The `<state>` of a saved
    world is left alone. Raises BrokenSdf, which says what is wrong where.
    """
    try:
        root = ElementTree.parse(file).getroot()
    except (OSError, ElementTree.ParseError) as cause:
        raise BrokenSdf(file, f"it cannot be read as XML ({cause})") from cause
    world = root if root.tag == "world" else root.find("world")
    if root.tag not in ("sdf", "world") or world is None:
        raise BrokenSdf(file, "it holds no <sdf> with a <world>")
    left_out = [
        f"included model {include.findtext('uri', 'without uri').strip()}"
        for include in world.findall("include")
    ]
    bodies = [body for model in world.findall("model") for body in _model(file, model, left_out)]
    finish = Body(
        name="goal",
        role="finish",
        geometry=GOAL,
        x=goal[0],
        y=goal[1],
        z=GOAL.z / 2,
        colour="#2f6fd0",
        solid=False,
    )
    way = _without_repeats([(start.x, start.y), *path, goal])
    title = f"{name or file.stem}, imported from {file.name}"
    try:
        made = World(
            name=name or file.stem,
            title=title,
            start=Start(x=start.x, y=start.y, theta=start.theta),
            bodies=(*bodies, finish),
            routes=(Route(name="reference", legs=(Leg(target="goal", path=tuple(way)),)),),
        )
    except ValidationError as fault:
        raise BrokenSdf(file, str(fault.errors()[0]["msg"])) from fault
    return Imported(made, tuple(left_out))


def _without_repeats(points: list[Point]) -> list[Point]:
    return [point for i, point in enumerate(points) if i == 0 or point != points[i - 1]]


def _model(file: Path, model: ElementTree.Element, left_out: list[str]) -> Iterator[Body]:
    """Give a body for every collision of a model that is not the floor."""
    name = model.get("name") or "unnamed"
    origin = Placed(PlanarPose(0.0, 0.0, 0.0), 0.0)
    at_model = _placed(file, name, model, origin)
    shapes = [
        (_placed(file, name, collision, _placed(file, name, link, at_model)), shape)
        for link in model.findall("link")
        for collision in link.findall("collision")
        for shape in collision.findall("geometry/*")
    ]
    solid = [(at, shape) for at, shape in shapes if shape.tag != "plane"]
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


def _placed(file: Path, name: str, element: ElementTree.Element, parent: Placed) -> Placed:
    """Compose an element's `<pose>` with its parent's."""
    text = element.findtext("pose")
    if text is None or not text.strip():
        return parent
    x, y, z, roll, pitch, yaw = _numbers(file, f"the pose of model '{name}'", text, 6)
    if abs(roll) > TILT or abs(pitch) > TILT:
        raise BrokenSdf(file, f"model '{name}' is tilted; only upright bodies can be read")
    at_x, at_y = parent.pose.to_world(x, y)
    return Placed(PlanarPose(at_x, at_y, parent.pose.theta + yaw), parent.z + z)


def _geometry(file: Path, name: str, shape: ElementTree.Element) -> Box | Cylinder | None:
    if shape.tag not in ("box", "cylinder"):
        return None
    try:
        if shape.tag == "box":
            x, y, z = _numbers(file, f"the box of model '{name}'", shape.findtext("size", ""), 3)
            return Box(x=x, y=y, z=z)
        radius, length = (
            _numbers(file, f"the {part} of model '{name}'", shape.findtext(part, ""), 1)[0]
            for part in ("radius", "length")
        )
        return Cylinder(radius=radius, length=length)
    except ValidationError:
        raise BrokenSdf(file, f"the {shape.tag} of model '{name}' has no size") from None


def _numbers(file: Path, what: str, text: str, count: int) -> list[float]:
    parts = text.split()
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        raise BrokenSdf(file, f"{what} is '{text.strip()}', not numbers") from None
    if len(numbers) != count:
        raise BrokenSdf(file, f"{what} is '{text.strip()}', where {count} numbers are needed")
    return numbers
