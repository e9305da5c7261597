"""What the emulated board does with a field: the right pin, the right duty, no steps."""

from __future__ import annotations

from collections.abc import Callable
from math import radians, sin

import numpy as np
import pytest
from stick_bench import Bench, diagonal, field


def turn(bench: Bench, counts: tuple[int, int, int]) -> None:
    """Turn the encoders slowly, and wait until the filtered rate is nothing."""
    for axis, count in enumerate(counts):
        bench.board.turn(axis, count, 5_000)
    bench.line.send(field())
    bench.line.listen(0.1)
    bench.line.send(field())
    bench.line.listen(0.05)


def test_a_wrench_drives_the_pin_of_its_sign(bench: Bench) -> None:
    bench.bare()
    assert bench.settle(field(wrench=(40, -50, 60))).motor == (40, -50, 60)
    assert bench.board.duties == (40, 0, 0, 50, 60, 0)
    assert bench.settle(field(wrench=(-40, 50, -60))).motor == (-40, 50, -60)
    assert bench.board.duties == (0, 40, 50, 0, 0, 60)


def test_both_pins_of_a_pair_are_never_on(bench: Bench) -> None:
    bench.bare(slew_limit=(255, 255, 255))
    for step in range(40):
        sign = 1 if step % 2 else -1
        bench.line.send(field(wrench=(200 * sign, -200 * sign, 200 * sign), valid_for=5))
        bench.line.listen(0.003)
    assert bench.board.greatest_duty() > 100
    assert bench.board.overlaps() == 0


def test_stiffness_pulls_back_to_about(bench: Bench) -> None:
    bench.bare()
    turn(bench, (100, -100, 200))
    assert bench.settle(field(stiffness=diagonal(0.5))).motor == (-50, 50, -100)
    about = bench.settle(field(stiffness=diagonal(0.5), about=(60, -40, 100)))
    assert about.motor == (-20, 30, -50)


def test_damping_works_against_the_rate(bench: Bench) -> None:
    bench.bare(travel=(2047, 2047, 2047))
    bench.settle(field(damping=diagonal(10)))
    for axis in range(3):
        bench.board.turn(axis, 1000, 2_000)
    last = bench.line.listen(0.1)[-1]
    assert last.rate == pytest.approx((512, 512, 512), abs=3)  # 2 counts/ms
    assert last.motor == pytest.approx((-20, -20, -20), abs=1)


def test_matrices_couple_the_axes(bench: Bench) -> None:
    bench.bare()
    turn(bench, (40, 80, -60))
    random = np.random.default_rng(6)
    for _ in range(8):
        stiffness = random.uniform(-0.8, 0.8, (3, 3))
        wrench = random.uniform(-60, 60, 3)
        about = random.uniform(-50, 50, 3)
        got = bench.settle(field(tuple(wrench), tuple(about), tuple(stiffness.ravel())))
        wanted = wrench - stiffness @ (np.array((40, 80, -60)) - about)
        assert np.allclose(got.motor, np.clip(wanted, -255, 255), atol=0.7)


def test_centring_and_gravity_compensation_are_the_thesis_firmware_s(bench: Bench) -> None:
    bench.arm()
    turn(bench, (120, -150, 400))
    last = bench.settle(field())
    # 0.7 PWM a degree of the motor (4 counts), theta 1.9 times that; 12 and 15 counts a degree of
    # the handle for the weight.
    x = -0.7 * 120 / 4 - 100 * sin(radians(120 / 12))
    y = 0.7 * 150 / 4 + 70 * sin(radians(150 / 15))
    assert last.motor == pytest.approx((x, y, -1.9 * 0.7 * 400 / 4), abs=0.7)


def test_a_wrench_comes_in_a_ramp_of_one_law_period(bench: Bench) -> None:
    bench.bare(slew_limit=(255, 255, 255))
    for _ in range(5):
        bench.line.send(field())
        bench.line.listen(0.02)
    bench.line.send(field(wrench=(200, 0, 0)))
    forces = [one.motor[0] for one in bench.line.listen(0.04)]
    assert forces[-1] == 200
    assert np.diff(forces).max() <= 11  # 200 PWM in 20 ticks


def test_a_change_of_stiffness_is_no_step(bench: Bench) -> None:
    bench.bare(slew_limit=(255, 255, 255))
    turn(bench, (200, 0, 0))
    forces = []
    for stiffness in (0.0, 1.0, 0.2, 0.9, 0.0):
        bench.line.send(field(stiffness=diagonal(stiffness)))
        forces += [one.motor[0] for one in bench.line.listen(0.02)]
    assert min(forces) < -150
    assert np.abs(np.diff(forces)).max() <= 12


def test_force_and_slew_are_limited_and_said_so(bench: Bench) -> None:
    bench.bare(force_limit=(100, 255, 255), slew_limit=(255, 5, 255))
    last = bench.settle(field(wrench=(150, 0, 0)))
    assert last.motor[0] == 100
    assert last.signs & 0x07 == 0x01
    bench.line.send(field(wrench=(0, 200, 0), valid_for=100))
    bench.line.send(field(wrench=(0, 200, 0), valid_for=100))
    heard = bench.line.listen(0.03)
    steps = np.diff([one.motor[1] for one in heard])
    assert steps.max() == 5
    assert any(one.signs & 0x08 for one in heard)


def test_a_motor_or_encoder_sign_turns_an_axis_round(bench: Bench) -> None:
    bench.bare(motor_sign=(-1, 1, 0), encoder_sign=(1, -1, 1))
    last = bench.settle(field(wrench=(40, 0, 40)))
    assert last.motor == (40, 0, 40)
    assert bench.board.duties == (0, 40, 0, 0, 0, 0)
    turn(bench, (10, 10, 10))
    assert bench.settle(field()).position == (10, -10, 10)


def test_the_same_run_gives_the_same_bytes(make_bench: Callable[[], Bench]) -> None:
    def run() -> bytes:
        bench = make_bench()
        bench.arm()
        bench.board.release()
        bench.board.hold(0, 200.0, 3.0, 0.5, 0.01)
        bench.line.send(field(wrench=(30, 20, 10), stiffness=diagonal(0.5)))
        bench.board.run(0.3)
        return bytes(bench.board.received())

    first = run()
    assert len(first) > 10_000
    assert run() == first


def test_a_field_that_is_valid_for_a_tick_is_felt_for_a_tick(bench: Bench) -> None:
    bench.bare(slew_limit=(255, 255, 255))
    bench.line.send(field(wrench=(100, 0, 0), valid_for=1))
    felt = [one.motor[0] for one in bench.line.listen(0.02)]
    assert [force for force in felt if force] == [100]
