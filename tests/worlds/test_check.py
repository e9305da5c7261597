"""What is wrong with a world is said before anybody drives in it."""

from __future__ import annotations

from typing import Any

import pytest
from core_world import wall

from omnistudy.scene import Body, Box, Hinge
from omnistudy.worlds import Leg, Route, Start, World
from omnistudy.worlds.check import WorldCheck, check_world

WIDTH, CIRCUMRADIUS = 0.38, 0.347


def finish(x: float = 4.0) -> Body:
    return Body(
        name="finish", role="finish", geometry=Box(x=0.1, y=0.1, z=0.1), x=x, y=0, z=0.05,
        solid=False,
    )  # fmt: skip


def corridor(half: float = 0.5, **changes: Any) -> World:
    """A straight corridor of a clear width of 2·half - 0.1, 4 m to the finish."""
    given: dict[str, Any] = {
        "name": "corridor",
        "start": Start(x=0, y=0),
        "bodies": (
            wall("left", (-1.0, half), (5.0, half)),
            wall("right", (-1.0, -half), (5.0, -half)),
            finish(),
        ),
        "routes": (Route(name="r", legs=(Leg(target="finish", path=((0, 0), (4, 0))),)),),
    }
    return World(**(given | changes))


def checked(world: World) -> WorldCheck:
    return check_world(world, WIDTH, CIRCUMRADIUS)


def test_a_sound_corridor_is_measured() -> None:
    found = checked(corridor())
    assert found.faults == ()
    (route,) = found.routes
    assert (route.length, route.turns, route.reversals) == (4.0, 0, 0)
    assert route.narrowest == pytest.approx(0.9, abs=0.01)  # 1 m less two half walls of 5 cm


def test_turns_and_ways_back_are_counted_apart() -> None:
    path = ((0, 0), (2, 0), (2, 2), (2, 0), (4, 0))
    found = checked(
        World(
            name="open",
            start=Start(x=0, y=0),
            bodies=(finish(),),
            routes=(Route(name="r", legs=(Leg(target="finish", path=path),)),),
        )
    )
    assert (found.routes[0].turns, found.routes[0].reversals) == (2, 1)


def test_a_start_in_a_wall_is_a_fault() -> None:
    (fault,) = [f for f in checked(corridor(start=Start(x=0, y=0.4))).faults if "starts" in f]
    assert "wall 'left'" in fault


def test_a_route_through_a_closed_wall_is_a_fault() -> None:
    closed = (*corridor().bodies, wall("closed", (2.0, -0.5), (2.0, 0.5)))
    (fault,) = checked(corridor(bodies=closed)).faults
    assert "leads through wall 'closed'" in fault


def test_a_passage_narrower_than_the_robot_is_a_fault() -> None:
    # Half the robot is 0.19 m wide and half a wall 0.05 m thick.
    left, right = checked(corridor(half=0.23)).faults[-2:]
    assert "0.18 m from wall 'left', nearer than half the robot's width" in left
    assert "0.18 m from wall 'right'" in right
    assert checked(corridor(half=0.25)).faults == ()


def test_a_door_on_a_hinge_may_be_driven_through_and_a_nailed_one_not() -> None:
    nailed = wall("door", (2.0, -0.5), (2.0, 0.5)).model_copy(update={"role": "door"})
    hinged = nailed.model_copy(update={"hinge": Hinge(x=-0.5), "mass": 5.0})
    assert checked(corridor(bodies=(*corridor().bodies, nailed))).faults != ()
    assert checked(corridor(bodies=(*corridor().bodies, hinged))).faults == ()


def test_a_leg_to_nothing_is_a_fault_with_the_nearest_name() -> None:
    route = Route(name="r", legs=(Leg(target="finsh", path=((0, 0), (4, 0))),))
    faults = checked(corridor(routes=(route,))).faults
    assert any("'finsh'" in fault and "did you mean 'finish'" in fault for fault in faults)


def test_legs_that_do_not_join_are_a_fault() -> None:
    legs = (
        Leg(target="finish", path=((0, 0), (4, 0))),
        Leg(target="finish", path=((3, 0), (4, 0))),
    )
    (fault,) = checked(corridor(routes=(Route(name="r", legs=legs),))).faults
    assert "does not join: the end of the leg to 'finish' is at (4.00, 0.00)" in fault
    assert "begins at (3.00, 0.00)" in fault


def test_a_route_without_a_finish_is_a_fault() -> None:
    block = finish().model_copy(update={"name": "red", "role": "target"})
    route = Route(name="r", legs=(Leg(target="red", path=((0, 0), (4, 0))),))
    world = corridor(bodies=(*corridor().bodies[:2], block), routes=(route,))
    assert any("no finish" in fault for fault in checked(world).faults)


def test_unequal_routes_are_a_warning_only() -> None:
    longer = Route(name="s", legs=(Leg(target="finish", path=((0, 0), (0, 0.1), (4, 0))),))
    found = checked(corridor(routes=(*corridor().routes, longer)))
    assert found.faults == ()
    assert any("long" in warning for warning in found.warnings)
