"""The route task: blocks in order, messages as the thesis shows them, clock, time limit, end."""

from __future__ import annotations

import pytest
from core_world import corner_world, messages

from omnistudy.channel import Event
from omnistudy.errors.worlds import UnknownRoute
from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.scene import Contacts, PlanarState
from omnistudy.tasks import Progress, RunningTask
from omnistudy.tasks.route import RouteTask
from omnistudy.worlds import Leg, Route

LEGS = {leg.target: leg for leg in corner_world().routes[0].legs}


class Play:
    """A task to which things happen, second by second."""

    def __init__(self, task: RunningTask) -> None:
        self.task = task
        self.collisions = 0
        self.told: list[tuple[float, str, str]] = []

    def at(
        self, t: float, touching: str = "", commanded: bool = True, colliding: bool = False
    ) -> Progress:
        others = (touching,) if touching else ()
        state = PlanarState(PlanarPose(0, 0, 0), PlanarTwist(0, 0, 0), Contacts(others=others))
        progress = self.task.update(t, state, commanded, self.collisions, colliding)
        self.told += [tuple(event) for event in progress.events]
        return progress

    def kinds(self) -> list[str]:
        return [kind for _, kind, _ in self.told]


@pytest.fixture
def play() -> Play:
    return Play(RouteTask().begin(corner_world(), "round", messages()))


def test_messages_word_for_word_and_in_order(play: Play) -> None:
    play.at(0.5)
    play.collisions = 1
    play.at(2.0, colliding=True)
    play.at(2.5, colliding=True)
    play.at(3.0)
    play.at(5.0, touching="red")
    for quarter in range(21, 40):
        play.at(quarter / 4)
    play.collisions = 2
    play.at(10.0, colliding=True)
    play.at(11.0)
    end = play.at(12.0, touching="finish")
    assert end.ended == "completed"
    assert play.told == [
        (0.5, "start", ""),
        (2.0, "message", "Drive away from wall 1"),
        (3.0, "message_closed", "Drive away from wall 1"),
        (5.0, "block", "red"),
        (5.0, "message", "Good Job"),
        (5.0, "message", "Move to Next Block"),
        (9.0, "message_closed", "Good Job"),
        (10.0, "message", "Drive away from wall 2"),
        (11.0, "message_closed", "Drive away from wall 2"),
        (12.0, "finish", "finish"),
        (12.0, "message", "Game Over - Next Round"),
        (12.0, "message", "Round Complete - Total Collision = 2"),
    ]


def test_the_person_is_shown_the_leg_and_the_warning(play: Play) -> None:
    assert play.task.situation.leg == LEGS["red"]
    play.collisions = 1
    assert play.at(1.0, colliding=True).situation.drive_away
    assert play.at(1.5, colliding=True).situation.drive_away
    assert not play.at(2.0).situation.drive_away
    assert play.at(3.0, touching="red").situation.leg == LEGS["finish"]


def test_the_finish_before_the_blocks_does_nothing(play: Play) -> None:
    play.at(0.5)
    assert play.at(1.0, touching="finish").ended == ""
    assert play.at(2.0, touching="red").ended == ""
    assert play.at(3.0, touching="finish").ended == "completed"
    assert [kind for kind in play.kinds() if kind in {"block", "finish"}] == ["block", "finish"]


def test_blocks_count_only_in_their_order() -> None:
    world = corner_world()
    red, finish = world.routes[0].legs
    blue = Leg(target="blue", path=finish.path)
    three = world.model_copy(update={"routes": (Route(name="three", legs=(red, blue, finish)),)})
    play = Play(RouteTask().begin(three, "three", messages()))
    for t, touching in enumerate(["blue", "finish", "red", "finish", "red", "blue", "finish"]):
        ended = play.at(float(t), touching=touching).ended
    assert [(t, what) for t, kind, what in play.told if kind in {"block", "finish"}] == [
        (2.0, "red"),
        (5.0, "blue"),
        (6.0, "finish"),
    ]
    assert ended == "completed"


def test_the_clock_starts_with_the_first_command(play: Play) -> None:
    assert not play.at(1.0, commanded=False).started
    assert play.at(1.5, commanded=True).started
    assert play.at(2.0, commanded=False).started
    assert play.told == [(1.5, "start", "")]


def test_time_is_up_three_times_the_way_at_top_speed_after_the_start() -> None:
    # the way round the corner is 6.5 m; at 0.36 m/s three times that is 54.17 s
    play = Play(RouteTask().begin(corner_world(), "round", messages()))
    play.at(9.0, commanded=False)
    play.at(10.0)
    assert play.at(64.1).ended == ""
    late = play.at(64.2)
    assert late.ended == "timed_out"
    assert late.events == (Event(64.2, "timed_out", "54 s"),)


def test_somebody_who_never_starts_is_timed_out_too(play: Play) -> None:
    assert play.at(54.1, commanded=False).ended == ""
    assert play.at(54.2, commanded=False).ended == "timed_out"


def test_reaching_the_finish_in_the_last_instant_counts(play: Play) -> None:
    play.at(0.0)
    play.at(1.0, touching="red")
    assert play.at(60.0, touching="finish").ended == "completed"


def test_duration_that_plans_reckon_with() -> None:
    # half as long again as 6.5 m at 0.36 m/s
    assert RouteTask().expected_duration(corner_world(), "round") == pytest.approx(27.083, abs=1e-3)
    assert RouteTask(top_speed=0.18).limit(corner_world(), "round") == pytest.approx(
        108.33, abs=0.01
    )


def test_an_unknown_route_is_refused() -> None:
    with pytest.raises(UnknownRoute, match="round"):
        RouteTask().begin(corner_world(), "rond", messages())
