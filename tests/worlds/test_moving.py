"""What `world check` says of moving bodies: for a time is a note, for good is a fault."""

from __future__ import annotations

from typing import Any

import pytest

from omnistudy.scene import Body, Box, Cylinder, Motion, Patrol, Timetable
from omnistudy.worlds import Leg, Route, Start, World, load_world
from omnistudy.worlds.check import WorldCheck, check_world
from omnistudy.worlds.page import write_world

POST = Cylinder(radius=0.3, length=1.0)


def mover(x: float, y: float, motion: Motion, shape: Box | Cylinder = POST) -> Body:
    return Body(name="cart", role="wall", geometry=shape, x=x, y=y, z=0.5, motion=motion)


def checked(*bodies: Body, **changes: Any) -> WorldCheck:
    """A way of 4 m along x in the open, for a robot 0.4 m wide and 0.58 m long."""
    finish = Body(
        name="finish", role="finish", geometry=Box(x=0.1, y=0.1, z=0.1), x=4, y=0, z=0.05,
        solid=False,
    )  # fmt: skip
    given: dict[str, Any] = {
        "name": "open",
        "start": Start(x=0, y=0),
        "bodies": (*bodies, finish),
        "routes": (Route(name="r", legs=(Leg(target="finish", path=((0, 0), (4, 0))),)),),
    }
    return check_world(World(**(given | changes)), 0.4, 0.352)


def test_a_crossing_is_a_note_with_its_place_and_time() -> None:
    # From y = -2 to 2 and back at 0.5 m/s: 16 s and 4 s of rest. It is in the way within 0.3 + 0.2
    # m of it: 1 m, or 2 s, twice.
    found = checked(mover(2.0, -2.0, Patrol(waypoints=((2.0, 2.0),), speed=0.5, pause=2.0)))
    assert found.faults == ()
    (note,) = found.notes
    where = "route 'r', leg to 'finish', at (2.00, 0.00)"
    assert note == f"{where}: 'cart' is in the way for 4.0 s of every 20.0 s"


def test_a_box_is_measured_by_its_sides() -> None:
    # Half of 1 m and half the robot: in the way from y = -0.7 to 0.7, twice in 8 s at 1 m/s.
    box = Box(x=0.4, y=1.0, z=1.0)
    (note,) = checked(mover(2.0, -2.0, Patrol(waypoints=((2.0, 2.0),), speed=1.0), box)).notes
    assert "is in the way for 2.8 s of every 8.0 s" in note


def test_what_passes_beside_the_way_is_nothing() -> None:
    found = checked(mover(0.0, 1.0, Patrol(waypoints=((4.0, 1.0),), speed=0.5)))
    assert (found.faults, found.notes, found.warnings) == ((), (), ())


def test_what_never_leaves_the_way_is_a_fault() -> None:
    (fault,) = checked(mover(2.0, 0.0, Patrol(waypoints=((2.0, 0.2),), speed=0.5))).faults
    assert fault == "route 'r', leg to 'finish', at (2.00, 0.00): 'cart' never leaves the way"


def test_what_comes_to_rest_in_the_way_is_a_fault() -> None:
    arrives = Timetable(stops=((4.0, 2.0, 0.0),), repeats=False)
    (fault,) = checked(mover(2.0, 2.0, arrives)).faults
    assert "never leaves the way" in fault
    leaves = Timetable(stops=((4.0, 2.0, -2.0),), repeats=False)
    found = checked(mover(2.0, 2.0, leaves))
    assert found.faults == ()
    assert "is in the way for 1.0 s of the first 4.0 s" in found.notes[0]


def test_a_start_where_something_comes_past_is_a_fault() -> None:
    # The robot reaches 0.29 m ahead: a body that passes 0.5 m ahead with 0.3 m to its side hits it.
    way = Patrol(waypoints=((0.5, 2.0),), speed=0.5)
    faults = checked(mover(0.5, -2.0, way)).faults
    assert faults == ("the robot starts at (0.00, 0.00), where 'cart' comes past",)
    box = Box(x=0.6, y=0.6, z=1.0)
    assert checked(mover(0.5, -2.0, way, box)).faults == faults
    further = Patrol(waypoints=((0.62, 2.0),), speed=0.5)
    assert checked(mover(0.62, -2.0, further)).faults == ()


def test_a_path_through_a_wall_is_a_warning() -> None:
    wall = Body(name="wall", role="wall", geometry=Box(x=1, y=0.1, z=1), x=2, y=1, z=0.5)
    (warning,) = checked(
        mover(2.0, -2.0, Patrol(waypoints=((2.0, 2.0),), speed=0.5)), wall
    ).warnings
    assert warning == "'cart' moves through wall 'wall'"


def test_the_crossing_that_ships_is_sound_and_survives_its_page(tmp_path: Any) -> None:
    world = load_world("crossing")
    found = check_world(world, 0.38, 0.347)
    assert found.faults == ()
    assert {note.split("'")[5] for note in found.notes} == {"trolley", "cart"}
    write_world(world, tmp_path / "again.yaml")
    assert load_world(tmp_path / "again.yaml") == world


@pytest.mark.parametrize("name", ["utah2017", "primitive_a"])
def test_a_world_where_nothing_moves_has_no_notes(name: str) -> None:
    assert check_world(load_world(name), 0.38, 0.347).notes == ()
