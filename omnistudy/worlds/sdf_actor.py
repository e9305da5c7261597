"""Actors of a Gazebo world: whoever follows a scripted trajectory is a moving cylinder."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

from omnistudy.errors.worlds import BrokenSdf
from omnistudy.scene import Body, Cylinder, Timetable
from omnistudy.worlds.sdf_numbers import numbers

PERSON = Cylinder(radius=0.25, length=1.7)
"""Room that an actor takes up (ours): its skin is a mesh, and it has no collision shape."""

Waypoint = tuple[float, float, float]
"""Time in s, x and y in m."""


def actors(file: Path, world: ElementTree.Element, left_out: list[str]) -> Iterator[Body]:
    """Give a cylinder for every actor of a world; what cannot be followed is named as left out.

    Waypoints are in the world's frame, their times count from the start of the script, and a loop
    waits for its delay again (Gazebo's `Actor.cc`). Gazebo smooths the path; we go straight.
    """
    for actor in world.findall("actor"):
        name = actor.get("name") or "unnamed"
        trajectories = actor.findall("script/trajectory")
        if len(trajectories) != 1 or actor.findtext("script/auto_start", "true") in ("false", "0"):
            left_out.append(f"actor '{name}', which has no single trajectory that starts by itself")
            continue
        waypoints = _waypoints(file, name, trajectories[0])
        if not waypoints:
            left_out.append(f"actor '{name}', whose trajectory has no waypoints")
            continue
        delay = actor.findtext("script/delay_start", "0")
        (wait,) = numbers(file, f"delay_start of actor '{name}'", delay, 1)
        loops = actor.findtext("script/loop", "true") in ("true", "1")
        body = _walking(name, [(wait + t, x, y) for t, x, y in waypoints], loops)
        if body is None:
            left_out.append(f"actor '{name}', who would leap from the end of the way to its start")
        else:
            yield body


def _waypoints(file: Path, name: str, trajectory: ElementTree.Element) -> list[Waypoint]:
    """Give the waypoints in the order of their times, which is all that counts."""
    found = sorted(_waypoint(file, name, one) for one in trajectory)
    for before, after in pairwise(found):
        if before[0] == after[0]:
            raise BrokenSdf(file, f"two waypoints of actor '{name}' have the time {after[0]:g}")
    return found


def _waypoint(file: Path, name: str, element: ElementTree.Element) -> Waypoint:
    what = f"waypoint of actor '{name}'"
    (t,) = numbers(file, f"the time of a {what}", element.findtext("time", ""), 1)
    x, y, *_ = numbers(file, f"the pose of a {what}", element.findtext("pose", ""), 6)
    if t < 0.0:
        raise BrokenSdf(file, f"the time of a {what} is {t:g}, before the script begins")
    return t, x, y


def _walking(name: str, stops: list[Waypoint], loops: bool) -> Body | None:
    """Give the cylinder; None where it would have to leap."""
    _, x, y = stops[0]
    places = [stop[1:] for stop in stops]
    if loops and places[0] != places[-1]:
        return None
    body = Body(
        name=name,
        role="wall",
        geometry=PERSON,
        x=x,
        y=y,
        z=PERSON.length / 2,
        colour="#c2410c",
    )
    if all(place == places[0] for place in places):
        return body
    later = tuple(stop for stop in stops if stop[0] > 0.0)
    return body.model_copy(update={"motion": Timetable(stops=later, repeats=loops)})
