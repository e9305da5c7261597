"""Between trials a hand may go: the stick is soft then, and has force again when a trial begins."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from faulty_stick import FaultyStickInMotion, connected

from omnistudy.devices import Hand
from omnistudy.geometry import ForceField, PlanarWrench

pytestmark = pytest.mark.usefixtures("toolchain")

HELD = Hand((0.01, 0.0, 0.0), (300.0, 300.0, 5.0), (12.0, 12.0, 0.15), (0.5, 0.5, 0.002))


def turn(stick: FaultyStickInMotion, ticks: int) -> int:
    """Turn as a device's process does; give the ticks until there was trouble, or all."""
    for tick in range(ticks):
        if tick % 20 == 0:
            stick.render(ForceField(PlanarWrench(1.0, 0.0, 0.0)))
        stick.advance(HELD)
        if stick.trouble():
            return tick
    return ticks


@pytest.fixture
def stick() -> Iterator[FaultyStickInMotion]:
    connection = connected()
    connection.wake()
    turn(connection, 100)
    connection.rest()
    yield connection
    connection.close()


def test_a_switch_that_is_let_go_in_a_rest_is_no_trouble(stick: FaultyStickInMotion) -> None:
    assert any(stick.board.duties)
    stick.board.hold_dead_man(False)
    assert turn(stick, 500) == 500
    assert stick.board.duties == (0,) * 6
    stick.board.hold_dead_man(True)
    stick.board.greatest_duty()
    assert turn(stick, 200) == 200
    assert stick.board.greatest_duty() == 0  # held again, but no trial has begun
    stick.wake()
    assert turn(stick, 300) == 300
    assert any(stick.board.duties)


def test_a_trial_that_begins_with_nobody_at_the_switch_is_in_trouble(
    stick: FaultyStickInMotion,
) -> None:
    stick.board.hold_dead_man(False)
    turn(stick, 50)
    stick.wake()
    assert turn(stick, 300) <= 102
    assert "DEAD_MAN" in stick.trouble()
    assert not stick.board.enabled


def test_an_emergency_stop_in_a_rest_has_to_be_checked(stick: FaultyStickInMotion) -> None:
    stick.inject("estop")
    assert turn(stick, 50) == 50
    stick.board.press_estop(False)
    stick.wake()
    assert turn(stick, 300) <= 102
    assert "ESTOP" in stick.trouble()


@pytest.mark.parametrize(
    ("fault", "told"), [("unplug", "nothing was heard"), ("brown_out", "started anew")]
)
def test_a_stick_that_is_lost_in_a_rest_is_told_at_once(
    stick: FaultyStickInMotion, fault: str, told: str
) -> None:
    stick.inject(fault)
    assert turn(stick, 300) <= 60
    assert told in stick.trouble()


def test_a_stick_may_be_connected_before_anybody_holds_it() -> None:
    stick = connected()
    stick.rest()
    stick.board.hold_dead_man(False)
    assert turn(stick, 100) == 100
    assert stick.identity().serial == "0"
    stick.board.hold_dead_man(True)
    stick.wake()
    assert turn(stick, 200) == 200
    assert any(stick.board.duties)


def test_energy_is_counted_from_the_beginning_of_a_trial(stick: FaultyStickInMotion) -> None:
    energy = [channel.name for channel in stick.channels].index("energy_x")
    assert stick.values()[energy] != 0.0
    stick.wake()
    stick.advance(HELD)
    assert stick.values()[energy] == pytest.approx(0.0, abs=1e-4)


def test_a_stick_that_was_held_all_the_time_is_not_armed_again(stick: FaultyStickInMotion) -> None:
    written = stick.line.written
    stick.wake()
    assert stick.line.written == written
