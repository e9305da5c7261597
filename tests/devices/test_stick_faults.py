"""Faults in the middle of driving: told within the times that docs/safety.md states, and soft.

Times are the board's own; a hand drives and a field comes 50 times a second meanwhile.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import pi, sin

import pytest
from core_world import trial
from faulty_stick import FaultyStickInMotion, connected

from omnistudy.devices import Hand
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.stick.ceiling import Ceiling
from omnistudy.geometry import ForceField, PlanarWrench
from omnistudy.laws.component import ComponentLaw
from omnistudy.trial import run_trial

pytestmark = pytest.mark.usefixtures("toolchain")

STIFFNESS, DAMPING, MASS = (300.0, 300.0, 5.0), (12.0, 12.0, 0.15), (0.5, 0.5, 0.002)
LOOSE = Hand((0.0, 0.0, 0.0), STIFFNESS, DAMPING, MASS)
WALL = ((250.0, 0.0, 0.0), (0.0, 250.0, 0.0), (0.0, 0.0, 1.0))


class Drive:
    """A hand that moves to and fro under a force that comes and goes."""

    def __init__(self, stick: FaultyStickInMotion) -> None:
        self.stick = stick
        self.tick = 0

    def on(self, seconds: float) -> float:
        """Drive on; give after how many seconds there was trouble, or `seconds`."""
        for tick in range(round(seconds * 1000)):
            if self._ticked():
                return (tick + 1) / 1000
        return seconds

    def _ticked(self) -> str:
        t = self.tick / 1000
        if self.tick % 20 == 0:
            push = 4.0 * sin(2 * pi * 0.7 * t)
            self.stick.render(ForceField(PlanarWrench(push, -push, 0.3), (0.0,) * 3, WALL))
        away = (0.012 * sin(2 * pi * 0.4 * t), 0.008 * sin(2 * pi * 0.3 * t), 0.2 * sin(t))
        self.stick.advance(Hand(away, STIFFNESS, DAMPING, MASS))
        self.tick += 1
        return self.stick.trouble()


@pytest.fixture
def drive() -> Iterator[Drive]:
    stick = connected()
    begun = Drive(stick)
    assert begun.on(1.0) == 1.0, stick.trouble()
    assert any(stick.board.duties)
    yield begun
    stick.close()


def is_soft(stick: FaultyStickInMotion) -> bool:
    """Whether no pin pushes and the amplifiers are off, ten ticks on."""
    for _ in range(10):
        stick.advance(LOOSE)
    board = stick.line.board
    return board.duties == (0,) * 6 and not board.enabled


@pytest.mark.parametrize(
    ("fault", "within", "told"),
    [
        ("brown_out", 0.05, "started anew \\(a brown-out\\)"),
        ("slow_telemetry", 1.0, "only 60% of its telemetry"),
        ("other_stick", 1.05, "another stick was plugged in: serial number 7"),
        ("estop", 0.003, "state FAULT; ESTOP"),
        ("dead_man", 0.003, "state IDLE; DEAD_MAN"),
        ("frozen_encoder", 0.6, "encoder of x stands still"),
    ],
)
def test_a_fault_is_told_in_time_and_leaves_the_stick_soft(
    drive: Drive, fault: str, within: float, told: str
) -> None:
    drive.stick.inject(fault)
    assert drive.on(within + 1.0) <= within
    assert re.search(told, drive.stick.trouble())
    assert is_soft(drive.stick)


def test_an_unplugged_stick_is_told_in_50_ms_and_fades_by_itself(drive: Drive) -> None:
    drive.stick.inject("unplug")
    assert drive.on(1.0) <= 0.055
    assert "nothing was heard" in drive.stick.trouble()
    # Disarming does not reach it any more: 200 ms of silence, 100 ms of fading.
    for _ in range(300):
        drive.stick.advance(LOOSE)
    assert is_soft(drive.stick)


def test_lost_counts_are_told_at_the_eleventh(drive: Drive) -> None:
    for _ in range(10):
        drive.stick.inject("lost_counts")
        assert drive.on(0.1) == 0.1
    drive.stick.inject("lost_counts")
    assert drive.on(0.1) <= 0.003
    assert "11 illegal steps" in drive.stick.trouble()
    assert is_soft(drive.stick)


def test_a_zero_that_lets_the_stick_stand_beyond_its_stop_is_told(drive: Drive) -> None:
    # The stop gives way: what the counts tell then is what a drifted zero tells.
    drive.stick.board.set(0, "travel", 0.1)
    push = Hand((0.06, 0.0, 0.0), (300.0, 300.0, 5.0), (60.0, 12.0, 0.15), MASS)
    for tick in range(1000):
        if tick % 20 == 0:
            drive.stick.render(ForceField(PlanarWrench(0.0, 0.0, 0.0)))
        drive.stick.advance(push)
    assert "the zero of x has drifted" in drive.stick.trouble()
    assert is_soft(drive.stick)


@pytest.mark.slow
def test_ten_seconds_at_a_limit_are_told(drive: Drive) -> None:
    held = Hand((0.02, 0.0, 0.0), (3000.0, 3000.0, 50.0), (60.0, 60.0, 1.0), MASS)
    for tick in range(11_000):
        if tick % 20 == 0:
            drive.stick.render(ForceField(PlanarWrench(-20.0, 0.0, 0.0)))
        drive.stick.advance(held)
        if drive.stick.trouble():
            break
    assert tick == pytest.approx(10_000, abs=100)
    assert "the force of x was at its limit" in drive.stick.trouble()
    assert is_soft(drive.stick)


def test_an_inverted_motor_that_runs_away_is_cut_by_the_firmware(drive: Drive) -> None:
    drive.stick.inject("inverted_motor")
    # A hand holds it by its switch alone; a wall's spring now pushes where it should pull.
    loose = Hand((0.004, 0.0, 0.0), (1.0, 300.0, 5.0), (0.1, 12.0, 0.15), (0.01, 0.5, 0.002))
    for tick in range(2000):
        if tick % 20 == 0:
            drive.stick.render(ForceField(PlanarWrench(0.0, 0.0, 0.0), (0.0,) * 3, WALL))
        drive.stick.advance(loose)
        if drive.stick.trouble():
            break
    assert re.search("VELOCITY|TRAVEL|zero of x has drifted", drive.stick.trouble())
    assert is_soft(drive.stick)


@pytest.mark.parametrize("fault", ["dead_motor", "inverted_motor"])
def test_what_a_hand_hides_is_not_told_while_driving(drive: Drive, fault: str) -> None:
    # As docs/safety.md lists: the checks find it before the next force.
    drive.stick.inject(fault)
    assert drive.on(3.0) == 3.0


def test_nothing_is_sent_and_nothing_driven_after_trouble(drive: Drive) -> None:
    drive.stick.inject("dead_man")
    drive.on(0.1)
    drive.stick.board.hold_dead_man(True)
    drive.stick.board.greatest_duty()
    cause = drive.stick.trouble()
    drive.stick.render(ForceField(PlanarWrench(10.0, 0.0, 0.0)))
    state = drive.stick.advance(Hand((0.01, 0.0, 0.0), STIFFNESS, DAMPING, MASS))
    assert drive.stick.trouble() == cause
    assert state.position == state.rate == (0.0, 0.0, 0.0)
    assert drive.stick.board.greatest_duty() == 0


def test_no_field_goes_out_any_more_after_trouble(drive: Drive) -> None:
    drive.stick.inject("estop")
    drive.on(0.1)
    written = drive.stick.line.written
    drive.stick.render(ForceField(PlanarWrench(10.0, 0.0, 0.0)))
    assert drive.stick.line.written == written


def test_a_lost_disarming_is_sent_again(drive: Drive) -> None:
    drive.stick.inject("frozen_encoder")
    drive.stick.line.swallowed = 3
    drive.on(2.0)
    assert "stands still" in drive.stick.trouble()
    assert is_soft(drive.stick)


def test_every_tick_is_told_as_a_row(drive: Drive) -> None:
    names = [axis.name for axis in drive.stick.axes]
    columns = [*names, *(f"{n}_rate" for n in names), *(c.name for c in drive.stick.channels)]
    rows = []
    for _ in range(200):
        drive.on(0.001)
        rows += drive.stick.rows()
    told = dict(zip(columns, zip(*rows, strict=True), strict=True))
    assert list(told["stick_tick"]) == list(
        range(int(told["stick_tick"][0]), int(told["stick_tick"][0]) + len(rows))
    )
    assert len(rows) in (199, 200, 201)
    assert set(told["stick_state"]) == {2.0}
    assert drive.stick.health().missed == 0


def test_who_it_is(drive: Drive) -> None:
    identity = drive.stick.identity()
    assert identity.model == "faulty_stick"
    assert identity.serial == "0"
    assert re.fullmatch("[0-9a-f]{8}", identity.firmware)


def test_a_dead_man_s_switch_that_nobody_holds_is_told_and_gives_no_force() -> None:
    stick = connected()
    stick.board.hold_dead_man(False)
    stick.render(ForceField(PlanarWrench(10.0, 0.0, 0.0)))
    assert "nobody holds the dead-man's switch" in stick.trouble()
    assert stick.board.greatest_duty() == 0


def test_the_ceiling_is_the_firmware_s_limit_too() -> None:
    stick = connected(ceiling=Ceiling(x=2.0, y=5.0, theta=1.0))
    held = Hand((0.02, 0.02, 0.3), (3000.0, 3000.0, 50.0), (60.0, 60.0, 1.0), MASS)
    for tick in range(500):
        if tick % 20 == 0:
            stick.render(ForceField(PlanarWrench(-20.0, -20.0, -4.0), (0.0,) * 3, WALL))
        stick.advance(held)
    assert not stick.trouble()
    # 255 steps are 13.5 N, 13.5 N and 4.4 N·m.
    assert stick.line.board.duties[1::2] == (37, 94, 57)
    # Saturated is at its limit, wherever that is.
    assert min(stick.health().saturated) > 300


@pytest.mark.slow
@pytest.mark.parametrize("seed", list("abcdefghij"))
def test_a_sound_stick_in_a_virtual_hand_is_never_in_trouble(seed: str) -> None:
    spec = trial(seed=seed, law=ComponentLaw(), device=EmulatedStickDevice())
    result = run_trial(spec)
    assert result.reason == ""
    assert result.status in ("completed", "timed_out")
