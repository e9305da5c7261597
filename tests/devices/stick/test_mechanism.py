"""The mechanism behind the emulated board, against motion worked out by hand."""

from __future__ import annotations

from math import exp

import pytest
from stick_bench import Bench, field

from omnistudy.devices.stick.emulator import Mechanism

PLAIN = Mechanism(mass=0.5, damping=0.0, per_count=1e-4, per_duty=0.05, travel=0.03)
PUSH = 2.0
"""N, of a hand that is a weak spring far away."""


@pytest.fixture
def plain(toolchain: None) -> Bench:
    return Bench((PLAIN, PLAIN, PLAIN))


def pull(bench: Bench, newtons: float, damping: float = 0.0, mass: float = 0.0) -> None:
    """Pull all axes with a force that hardly changes on the way."""
    for axis in range(3):
        bench.board.hold(axis, 1e-3, damping, mass, newtons / 1e-3)


def test_a_pull_accelerates_the_mass(plain: Bench) -> None:
    pull(plain, PUSH)
    plain.board.release()
    plain.board.run(0.05)
    for axis in range(3):
        assert plain.board.get(axis, "rate") == pytest.approx(PUSH / 0.5 * 0.05, rel=0.01)
        assert plain.board.get(axis, "position") == pytest.approx(0.5 * 4.0 * 0.05**2, rel=0.02)
        assert plain.board.count(axis) == pytest.approx(50, abs=1)


def test_a_hand_s_mass_is_carried_along(plain: Bench) -> None:
    pull(plain, PUSH, mass=1.5)
    plain.board.release()
    plain.board.run(0.05)
    assert plain.board.get(0, "rate") == pytest.approx(PUSH / 2.0 * 0.05, rel=0.01)


def test_a_hand_s_damping_takes_the_speed(plain: Bench) -> None:
    pull(plain, 0.0, damping=5.0)
    plain.board.set(0, "rate", 0.1)
    plain.board.release()
    plain.board.run(0.1)
    assert plain.board.get(0, "rate") == pytest.approx(0.1 * exp(-5.0 * 0.1 / 0.5), rel=0.01)


def test_a_stop_takes_all_speed(plain: Bench) -> None:
    pull(plain, PUSH)
    plain.board.release()
    plain.board.run(0.3)
    assert plain.board.get(0, "position") == PLAIN.travel
    pull(plain, -PUSH)
    plain.board.run(0.05)
    gone = PLAIN.travel - plain.board.get(0, "position")
    assert gone == pytest.approx(0.5 * 4.0 * 0.05**2, rel=0.02)


def test_a_handle_out_of_plumb_topples(toolchain: None) -> None:
    heavy = Mechanism(0.5, 0.0, 1e-4, 0.05, 0.03, weight=5.0, lever=0.1)
    bench = Bench((heavy, heavy, heavy))
    bench.board.set(0, "position", 0.01)
    bench.board.release()
    bench.board.run(0.01)
    # 5 N times the sine of 0.1 rad on 0.5 kg.
    assert bench.board.get(0, "rate") == pytest.approx(5.0 * 0.0998 / 0.5 * 0.01, rel=0.02)


@pytest.mark.parametrize(("state", "counted"), [(1.0, 20), (0.0, 0), (-1.0, -20)])
def test_an_encoder_is_sound_frozen_or_turned_round(
    plain: Bench, state: float, counted: int
) -> None:
    plain.board.set(0, "encoder", state)
    plain.board.set(0, "position", 0.002)
    plain.board.release()
    last = plain.line.listen(0.02)[-1]
    assert last.position[0] == counted


def test_an_encoder_that_freezes_stays_where_it_is(plain: Bench) -> None:
    plain.board.release()
    plain.board.set(0, "position", 0.002)
    plain.line.listen(0.02)
    plain.board.set(0, "encoder", 0.0)
    plain.board.set(0, "position", 0.004)
    assert plain.line.listen(0.02)[-1].position[0] == 20


@pytest.mark.parametrize(
    ("state", "band", "force"),
    [(1.0, 0.0, 5.0), (0.0, 0.0, 0.0), (-1.0, 0.0, -5.0), (1.0, 30, 3.5)],
)
def test_a_motor_pushes_on_a_load_cell(
    plain: Bench, state: float, band: float, force: float
) -> None:
    plain.board.set(0, "motor", state)
    plain.board.set(0, "dead_band", band)
    plain.board.clamp(0)
    plain.board.release()
    plain.bare()
    plain.settle(field(wrench=(100, 0, 0)))
    plain.board.run(0.02)
    assert plain.board.cell_force(0) == pytest.approx(force, abs=0.01)


def test_a_stick_that_is_disarmed_pushes_nothing(plain: Bench) -> None:
    plain.board.clamp(0)
    plain.board.release()
    plain.bare()
    plain.settle(field(wrench=(100, 0, 0)))
    plain.line.disarm()
    plain.board.run(0.02)
    assert plain.board.cell_force(0) == pytest.approx(0.0, abs=1e-3)
