"""Scripted paths: where a body is at a time follows from its page alone."""

from __future__ import annotations

from itertools import pairwise
from math import dist, hypot

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from omnistudy.scene import Body, Cylinder, Motion, Patrol, Timetable

coordinate = st.integers(-50, 50).map(lambda tenths: tenths / 10)
place = st.tuples(coordinate, coordinate)


@st.composite
def patrols(draw: st.DrawFn) -> tuple[tuple[float, float], Patrol]:
    home, waypoints = draw(place), draw(st.lists(place, min_size=1, max_size=5))
    corners = [home, *waypoints, home]
    if not all(dist(a, b) > 0 for a, b in pairwise(corners[:-1])) or corners[-2] == home:
        waypoints = [(home[0] + 1.0 + 0.1 * i, home[1]) for i in range(len(waypoints))]
    return home, Patrol(
        waypoints=tuple(waypoints),
        speed=draw(st.floats(0.05, 3.0)),
        course=draw(st.sampled_from(["there_and_back", "round"])),
        pause=draw(st.sampled_from([0.0, 0.5, 2.0])),
        offset=draw(st.floats(0.0, 100.0)),
    )


def test_there_and_back_with_a_pause_at_either_end() -> None:
    # 2 m at 0.5 m/s take 4 s; 1 s stay; 4 s back; 1 s stay: a period of 10 s.
    track = Patrol(waypoints=((2.0, 1.0),), speed=0.5, pause=1.0).track((0.0, 1.0))
    assert track.period == 10.0
    assert track.at(0.0) == (0.0, 1.0, 0.5, 0.0)
    assert track.at(3.0) == (1.5, 1.0, 0.5, 0.0)
    assert track.at(4.5) == (2.0, 1.0, 0.0, 0.0)
    assert track.at(7.0) == (1.0, 1.0, -0.5, 0.0)
    assert track.at(9.5) == (0.0, 1.0, 0.0, 0.0)
    assert track.at(13.0) == track.at(3.0)


def test_there_and_back_comes_back_the_way_it_went() -> None:
    # Two sides of a 3-4-5 triangle, 7 m at 1 m/s, and the same two back.
    track = Patrol(waypoints=((3.0, 0.0), (3.0, 4.0)), speed=1.0).track((0.0, 0.0))
    assert track.period == 14.0
    assert track.at(9.0) == (3.0, 2.0, 0.0, -1.0)
    assert track.at(12.5) == (1.5, 0.0, -1.0, 0.0)


def test_a_round_goes_straight_home_and_waits_there_alone() -> None:
    # Along two sides of a 3-4-5 triangle and back along the long one: 12 m at 1 m/s.
    track = Patrol(waypoints=((3.0, 0.0), (3.0, 4.0)), speed=1.0, course="round", pause=2.0).track(
        (0.0, 0.0)
    )
    assert track.period == 14.0
    assert track.at(7.0)[:2] == (3.0, 4.0)
    assert track.at(9.5) == pytest.approx((1.5, 2.0, -0.6, -0.8))
    assert track.at(13.0) == (0.0, 0.0, 0.0, 0.0)


def test_an_offset_begins_the_course_later_on() -> None:
    patrol = Patrol(waypoints=((2.0, 0.0),), speed=0.5, offset=3.0)
    assert patrol.track((0.0, 0.0)).at(0.0) == (1.5, 0.0, 0.5, 0.0)


@given(patrols(), st.floats(0.0, 200.0))
def test_a_patrol_goes_at_its_speed_without_a_leap_and_repeats(
    given_patrol: tuple[tuple[float, float], Patrol], t: float
) -> None:
    home, patrol = given_patrol
    track = patrol.track(home)
    here, short = track.at(t), 1e-4
    speed = hypot(here.vx, here.vy)
    assert speed == pytest.approx(patrol.speed, rel=1e-6) or (speed == 0.0 and patrol.pause > 0)
    assert dist(here[:2], track.at(t + short)[:2]) <= patrol.speed * short * (1 + 1e-5)
    assert track.at(t + track.period)[:2] == pytest.approx(here[:2], abs=1e-6)
    assert track.at(track.period - patrol.offset % track.period)[:2] == pytest.approx(
        home, abs=1e-6
    )


@given(st.lists(st.tuples(st.floats(0.1, 5.0), place), min_size=1, max_size=6), st.booleans())
def test_a_timetable_is_on_time_and_goes_straight_between(
    rows: list[tuple[float, tuple[float, float]]], repeats: bool
) -> None:
    home, t, stops = (0.5, 0.5), 0.0, []
    for duration, (x, y) in rows:
        t += duration
        stops.append((t, x, y))
    if repeats:
        stops.append((t + 1.0, *home))
    track = Timetable(stops=tuple(stops), repeats=repeats).track(home)
    for (before, ax, ay), (after, bx, by) in pairwise(((0.0, *home), *stops)):
        assert track.at((before + after) / 2)[:2] == pytest.approx(
            ((ax + bx) / 2, (ay + by) / 2), abs=1e-9
        )
    if not repeats:
        assert track.at(stops[-1][0] + 7.0) == (*stops[-1][1:], 0.0, 0.0)


def body(motion: Motion, **changes: object) -> Body:
    return Body.model_validate(
        {
            "name": "cart",
            "role": "wall",
            "geometry": Cylinder(radius=0.2, length=1.0),
            "x": 0.0,
            "y": 0.0,
            "z": 0.5,
            "motion": motion,
            **changes,
        }
    )


@pytest.mark.parametrize(
    ("motion", "changes", "said"),
    [
        (Patrol(waypoints=((0.0, 0.0),), speed=1.0), {}, "must lead somewhere else"),
        (Patrol(waypoints=((1.0, 0.0),), speed=1.0), {"solid": False}, "must be a solid wall"),
        (Patrol(waypoints=((1.0, 0.0),), speed=1.0), {"role": "target"}, "must be a solid wall"),
        (Timetable(stops=((2.0, 1.0, 0.0),)), {}, "must end at the body's own place (0, 0)"),
    ],
)
def test_a_motion_that_cannot_be_is_refused(
    motion: Motion, changes: dict[str, object], said: str
) -> None:
    with pytest.raises(ValidationError, match="Value error") as refused:
        body(motion, **changes)
    assert said in str(refused.value)


def test_times_of_stops_must_grow() -> None:
    with pytest.raises(ValidationError, match="must grow"):
        Timetable(stops=((1.0, 1.0, 0.0), (1.0, 0.0, 0.0)))


def test_a_moving_body_closes_no_way_for_good() -> None:
    assert not body(Patrol(waypoints=((1.0, 0.0),), speed=1.0)).blocks
