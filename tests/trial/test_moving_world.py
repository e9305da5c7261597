"""Whole trials among moving bodies: seen, let pass, touched, and the same again."""

from __future__ import annotations

from functools import cache

import pytest
from core_world import straight_world, trial

from omnistudy.operators.virtual_driver import Decision, VirtualDriver
from omnistudy.scene import Body, Cylinder, Patrol
from omnistudy.trial import TrialResult, resimulate, run_trial
from omnistudy.worlds import World

STEADY = VirtualDriver(skill_median=0.0, skill_spread=0.0)
BLIND = VirtualDriver(
    skill_median=0.0, skill_spread=0.0, decision=Decision(foresight=0.0, berth=0.0)
)


def crossed(offset: float) -> World:
    """A straight way of 4 m that a trolley crosses half-way."""
    trolley = Body(
        name="trolley",
        role="wall",
        geometry=Cylinder(radius=0.25, length=0.9),
        x=2.0,
        y=-2.0,
        z=0.45,
        motion=Patrol(waypoints=((2.0, 2.0),), speed=0.4, offset=offset),
    )
    straight = straight_world(4.0)
    return straight.model_copy(update={"bodies": (straight.bodies[-1], trolley)})


@cache
def drives(driver: VirtualDriver) -> tuple[TrialResult, ...]:
    """The same way at four moments of the trolley's course, one driver."""
    return tuple(
        run_trial(trial(crossed(offset), operator=driver)) for offset in (0.0, 2.5, 5.0, 7.5)
    )


def test_a_driver_waits_for_what_crosses_and_goes_on_when_it_is_clear() -> None:
    assert [drive.collisions for drive in drives(STEADY)] == [0, 0, 0, 0]
    assert {drive.status for drive in drives(STEADY)} == {"completed"}


def test_a_driver_who_does_not_look_runs_into_it_and_is_quicker_if_lucky() -> None:
    blind = drives(BLIND)
    touched = [drive for drive in blind if drive.collisions]
    assert touched
    details = {e.detail for drive in touched for e in drive.events if e.kind == "collision"}
    assert details == {"trolley"}
    assert min(drive.duration_s for drive in blind) <= min(d.duration_s for d in drives(STEADY))


@pytest.mark.parametrize("driver", [STEADY, BLIND], ids=["waits", "blind"])
def test_a_trial_among_moving_bodies_resimulates_from_its_input_alone(
    driver: VirtualDriver,
) -> None:
    for offset, first in zip((0.0, 2.5), drives(driver), strict=False):
        recorded = next(stream for stream in first.streams if stream.name == "input")
        again = resimulate(trial(crossed(offset), operator=driver), recorded.data)
        assert again.samples.tobytes() == first.samples.tobytes()
        assert (again.events, again.collisions) == (first.events, first.collisions)


def test_the_same_trial_gives_the_same_bytes() -> None:
    again = run_trial(trial(crossed(0.0), operator=BLIND))
    first = drives(BLIND)[0]
    assert again.samples.tobytes() == first.samples.tobytes()
    assert again.events == first.events
