"""What a tick costs, in processor cycles, and that none is missed."""

from __future__ import annotations

from itertools import pairwise

import pytest
from stick_bench import Bench, field

from omnistudy.devices.stick.emulator import HERTZ
from omnistudy.devices.stick.frames import encode
from omnistudy.devices.stick.messages import (
    CYCLES_PER_TICK,
    TICK_HZ,
    Fault,
    GetConfiguration,
    SetConfiguration,
    Telemetry,
)

RATED = 9_900
"""Edges a second and axis: just below the velocity trip."""
DENSE = field((30, 20, 10), (5, 5, 5), (0.3, 0.1, 0.1) * 3, (3, 1, 1) * 3, 100)
"""A field in which nothing is zero."""


def worst_case(
    bench: Bench, rate: float = RATED, steps: int = 30, twist: float | None = None
) -> list[Telemetry]:
    """Turn all encoders to and fro under centring, gravity and a dense field."""
    bench.arm(travel=(2047, 2047, 2047), velocity_trip=(2560, 2560, 3840 if twist else 2560))
    heard = []
    for step in range(steps):
        if step % 6 == 0:
            for axis, speed in enumerate((rate, rate, twist or rate)):
                bench.board.turn(axis, -1000 if bench.board.count(axis) > 0 else 1000, speed)
        bench.line.send(DENSE)
        heard += bench.line.listen(0.02)
    return heard


@pytest.mark.parametrize("twist", [None, 14_900], ids=["rated", "a twist as fast as emulated"])
def test_no_tick_is_missed_at_the_rated_speed(bench: Bench, twist: float | None) -> None:
    heard = worst_case(bench, twist=twist)
    assert all(later.tick - earlier.tick == 1 for earlier, later in pairwise(heard))
    assert heard[-1].missed == 0
    assert heard[-1].faults & 0xFF == 0


def test_a_tick_takes_less_than_half_its_cycles_to_drive_the_motors(bench: Bench) -> None:
    heard = worst_case(bench)
    assert max(one.worked for one in heard) < CYCLES_PER_TICK / 2
    assert max(one.busy for one in heard) < CYCLES_PER_TICK


@pytest.mark.parametrize("shift", [0, 30, 60, 90, 120])
def test_no_message_is_begun_while_a_tick_waits(bench: Bench, shift: int) -> None:
    """Settings take 4000 cycles to obey: begun between a tick's moment and its interrupt, which may
    wait behind the encoders', they would make that tick late by as much."""
    wanted = SetConfiguration(*bench.line.configuration())
    bench.board.run(shift / HERTZ)
    for axis in range(3):
        bench.board.turn(axis, 30_000, TICK_HZ * 16)  # sixteen edges a tick, always in step with it
        bench.board.run(60 / HERTZ)
    late = []
    for _ in range(600):
        bench.line.send(wanted)
        bench.board.run(37 / HERTZ)  # so that settings come at every moment of a tick
        late += [one.late for one in bench.line.listen(0.003)]
    assert max(late) < 1000


@pytest.mark.parametrize("rate", [1_000, 4_000, RATED])
def test_the_encoders_are_read_at_an_even_pace(bench: Bench, rate: float) -> None:
    late = [one.late for one in worst_case(bench, rate, 60)]
    assert max(late) - min(late) < 320  # 20 us


def test_no_telemetry_is_lost_however_much_a_host_asks(bench: Bench) -> None:
    """Six bytes ask for a configuration of sixty-six: more than the line can carry."""
    bench.board.write(b"".join(encode(GetConfiguration(), index) for index in range(200)))
    heard = bench.line.listen(0.05)
    assert bench.board.waiting == 0
    assert all(later.tick - earlier.tick == 1 for earlier, later in pairwise(heard))
    assert len(heard) >= 48


def test_an_answer_finds_room_behind_two_configurations(bench: Bench) -> None:
    """The line carries three spare bytes in a tick: what it still holds must not cost an answer."""
    for _ in range(2):
        bench.line.configuration()
    bench.line.arm()
    for _ in range(10):
        bench.line.configuration()  # asked again where it finds no room
        bench.line.disarm()


def test_a_field_changes_the_pwm_within_four_milliseconds_of_its_sending(bench: Bench) -> None:
    bench.bare()
    bench.settle(field())
    delays = []
    for index in range(20):
        wrench = 100 if index % 2 else 50
        bench.settle(field(wrench=(wrench, 0, 0)))
        bench.board.run(0.00013)
        before, began = bench.board.duties, bench.board.now()
        bench.line.send(field(wrench=(150 - wrench, 0, 0), valid_for=1))
        while bench.board.duties == before:
            bench.board.run(20e-6)
        delays.append(bench.board.now() - began)
    assert min(delays) > 0.0013  # 61 bytes of 22 us
    assert max(delays) < 0.004


def test_more_edges_than_the_processor_can_count_turn_the_force_off(bench: Bench) -> None:
    for axis in range(3):
        bench.board.turn(axis, -2000, 30_000)
    bench.line.listen(0.1)
    bench.bare(travel=(2047, 2047, 2047), velocity_trip=(8191, 8191, 8191))
    bench.settle(field(wrench=(100, 100, 100)))
    for axis in range(3):
        bench.board.turn(axis, 2000, 60_000)  # six times the rated speed
    faults = bench.line.listen(0.1)[-1].faults
    assert faults & (Fault.OVERRUN | Fault.WATCHDOG)
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled


def test_ticks_that_are_missed_are_counted_and_time_goes_on(bench: Bench) -> None:
    for axis in range(3):
        bench.board.turn(axis, -2000, 30_000)
    bench.line.listen(0.1)
    bench.bare(travel=(2047, 2047, 2047), velocity_trip=(8191, 8191, 8191))
    before, began = bench.line.listen(0.002)[-1], bench.board.now()
    bench.settle(field(wrench=(100, 100, 100)))
    for axis in range(3):
        bench.board.turn(axis, 2000, 50_000)  # a little more than the processor can count
    heard = bench.line.listen(0.15)
    last = heard[-1]
    gaps = sum(later.tick - earlier.tick - 1 for earlier, later in pairwise(heard))
    assert 0 < last.missed == gaps
    assert last.tick - before.tick == round((bench.board.now() - began) * TICK_HZ)
