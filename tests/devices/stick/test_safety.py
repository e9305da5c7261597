"""What takes the force away, how fast, and what gives it back."""

from __future__ import annotations

import numpy as np
import pytest
from stick_bench import Bench, diagonal, field

from omnistudy.devices.stick.frames import encode
from omnistudy.devices.stick.messages import ARM_KEY, Arm, Fault, State
from omnistudy.errors.devices import Refused

TICK = 1e-3
PUSH = field(wrench=(100, -100, 100), valid_for=250)


def push(bench: Bench) -> None:
    """Have the board push on all axes."""
    bench.settle(PUSH)
    assert bench.board.duties == (100, 0, 0, 100, 100, 0)


def assert_off(bench: Bench, state: State, fault: Fault) -> None:
    last = bench.line.listen(0.005)[-1]
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled
    assert last.state == state
    assert Fault(last.faults) & fault


def test_there_is_no_force_before_arm(bench: Bench) -> None:
    for _ in range(5):
        bench.line.send(PUSH)
        bench.line.listen(0.02)
    assert bench.board.greatest_duty() == 0
    assert not bench.board.enabled


def test_soft_start_grows_evenly(bench: Bench) -> None:
    bench.bare(soft_start=10)
    bench.line.disarm()
    bench.line.configure(bench.line.configuration()._replace(soft_start=1000))
    bench.line.arm()
    forces = []
    for _ in range(50):
        bench.line.send(field(wrench=(200, 0, 0)))
        forces.append(bench.line.listen(0.02)[-1].motor[0])
    assert forces[24] == pytest.approx(100, abs=5)
    assert forces[12] == pytest.approx(52, abs=5)
    assert forces == sorted(forces)
    assert forces[-1] == pytest.approx(200, abs=4)


def test_a_stale_field_fades_over_as_long_as_it_was_valid(bench: Bench) -> None:
    bench.bare(silence=1000)
    bench.settle(field(wrench=(100, 0, 0), valid_for=100))
    forces = [one.motor[0] for one in bench.line.listen(0.25)]
    # The field came 30 ms ago: 70 ms whole, 100 ms fading.
    assert forces[67] == 100
    assert forces[120] == pytest.approx(50, abs=3)
    assert forces[173:] == [0] * len(forces[173:])
    assert forces == sorted(forces, reverse=True)


def test_the_spring_of_a_stale_field_fades_too(bench: Bench) -> None:
    bench.bare(silence=1000)
    bench.board.turn(0, 100, 5_000)
    bench.line.listen(0.1)
    bench.settle(field(stiffness=diagonal(1.0), valid_for=50))
    forces = [one.motor[0] for one in bench.line.listen(0.15)]
    assert forces[0] == -100
    assert forces[-1] == 0
    assert np.abs(np.diff(forces)).max() <= 3  # 100 PWM in 50 ticks


def test_a_silent_host_leaves_the_stick_soft_within_silence_and_fade(bench: Bench) -> None:
    bench.arm(silence=200, fade=100)
    bench.board.turn(0, 200, 5_000)
    for _ in range(10):
        bench.line.send(field(wrench=(50, 0, 0), valid_for=100))
        bench.line.listen(0.02)
    heard = bench.line.listen(0.4)
    assert heard[150].motor[0] != 0  # the centring still works
    assert heard[190].state == State.FADING
    assert all(one.motor == (0, 0, 0) for one in heard[282:])
    assert_off(bench, State.IDLE, Fault.SILENT)


def test_fields_that_are_refused_are_no_sign_of_life(bench: Bench) -> None:
    bench.arm(silence=50, fade=100)
    sent = bench.line.send(PUSH)
    for _ in range(20):
        bench.board.write(encode(PUSH, sent))  # repeated
        bench.board.write(encode(PUSH._replace(valid_for=251), sent + 1))  # illegal
        bench.line.listen(0.01)
    assert_off(bench, State.IDLE, Fault.SILENT)


def test_a_host_that_speaks_again_in_time_gets_its_force_back(bench: Bench) -> None:
    bench.arm(silence=50, fade=100)
    bench.board.turn(0, 200, 5_000)
    bench.line.send(field())
    heard = bench.line.listen(0.1)
    assert heard[-1].state == State.FADING
    for _ in range(3):
        bench.line.send(field())
        heard = bench.line.listen(0.02)
    assert heard[-1].state == State.FORCE


def test_the_emergency_stop_acts_at_the_next_tick_and_latches(bench: Bench) -> None:
    bench.bare()
    push(bench)
    bench.board.press_estop(True)
    bench.board.run(1.5 * TICK)
    assert_off(bench, State.FAULT, Fault.ESTOP)
    with pytest.raises(Refused, match="fault is latched"):
        bench.line.clear_faults()
    bench.board.press_estop(False)
    bench.line.listen(0.01)
    with pytest.raises(Refused, match="fault is latched"):
        bench.line.arm()
    bench.line.clear_faults()
    bench.line.arm()
    assert bench.board.enabled


def test_letting_go_of_the_dead_man_s_switch_acts_at_the_next_tick(bench: Bench) -> None:
    bench.bare()
    push(bench)
    bench.board.hold_dead_man(False)
    bench.board.run(1.5 * TICK)
    assert_off(bench, State.IDLE, Fault.DEAD_MAN)
    with pytest.raises(Refused, match="nobody holds"):
        bench.line.arm()
    bench.board.hold_dead_man(True)
    bench.line.listen(0.05)
    assert bench.board.duties == (0,) * 6
    bench.line.arm()


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_velocity_trip(bench: Bench, axis: int) -> None:
    rate = 10  # counts/ms
    bench.bare(travel=(2047, 2047, 2047))
    push(bench)
    bench.board.turn(axis, 500, 0.9 * rate * 1000)
    assert bench.line.listen(0.02)[-1].state == State.FORCE
    bench.board.turn(axis, 1000, 1.2 * rate * 1000)
    bench.line.listen(0.02)
    assert_off(bench, State.FAULT, Fault.VELOCITY)


def test_a_runaway_beyond_its_travel_is_cut(bench: Bench) -> None:
    bench.bare()
    push(bench)
    bench.board.turn(1, 361, 8_000)
    bench.line.listen(0.05)
    assert_off(bench, State.FAULT, Fault.TRAVEL)


def test_an_inverted_motor_trips_and_goes_soft(bench: Bench) -> None:
    bench.arm()
    bench.board.release()
    bench.board.set(0, "motor", -1.0)
    bench.board.set(0, "position", 0.002)
    for _ in range(50):
        bench.line.send(field())
        heard = bench.line.listen(0.02)
        if heard[-1].state == State.FAULT:
            break
    assert bench.board.duties == (0,) * 6
    assert heard[-1].faults & (Fault.VELOCITY | Fault.TRAVEL)


def test_a_noisy_encoder_line_is_cut(bench: Bench) -> None:
    bench.bare(glitch_limit=5)
    push(bench)
    for _ in range(20):
        bench.board.jump(0)
        bench.board.run(TICK)
    assert_off(bench, State.FAULT, Fault.ENCODER)


def test_few_illegal_steps_a_second_are_no_fault(bench: Bench) -> None:
    bench.bare(glitch_limit=5)
    for _ in range(3):
        for _ in range(4):
            bench.board.jump(0)
            bench.board.run(TICK)
        for _ in range(10):
            bench.line.send(PUSH)
            heard = bench.line.listen(0.12)
    assert heard[-1].glitches == 12
    assert heard[-1].state == State.FORCE


@pytest.mark.parametrize(("interrupts", "within"), [(True, 0.017), (False, 0.033)])
def test_a_program_that_hangs_is_cut_by_the_watchdog(
    bench: Bench, interrupts: bool, within: float
) -> None:
    bench.bare()
    push(bench)
    bench.board.hang(interrupts)
    bench.board.run(within + TICK)
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled
    bench.board.heal()
    bench.line.listen(0.05)
    assert_off(bench, State.FAULT, Fault.WATCHDOG)
    assert bench.line.identify().reset_cause == 8


def test_the_watchdog_s_interrupt_itself_turns_all_off(bench: Bench) -> None:
    """It relies on no start: here the program never comes to life again."""
    bench.bare()
    push(bench)
    bench.board.hang(interrupts=True)
    bench.board.hang_at_start()
    bench.board.run(0.017 + TICK)
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled
    bench.board.heal()
    bench.line.listen(0.05)
    assert_off(bench, State.FAULT, Fault.WATCHDOG)


def test_a_brown_out_while_forcing_leaves_no_force(bench: Bench) -> None:
    bench.bare()
    push(bench)
    bench.board.brown_out()
    assert bench.board.duties == (0,) * 6
    assert not bench.board.enabled
    bench.board.greatest_duty()
    for _ in range(5):
        bench.line.send(PUSH)
        heard = bench.line.listen(0.02)
    assert heard[-1].tick < 120
    assert heard[-1].state == State.IDLE
    assert bench.board.greatest_duty() == 0
    assert bench.line.identify().reset_cause == 4


def test_a_stick_beyond_its_travel_is_not_armed(bench: Bench) -> None:
    bench.board.turn(0, 361, 5_000)
    bench.line.listen(0.1)
    with pytest.raises(Refused, match="beyond its travel"):
        bench.line.arm()
    bench.board.turn(0, 0, 5_000)
    bench.line.listen(0.1)
    bench.line.arm()


def test_an_emergency_stop_pressed_while_arm_is_read_forbids_it(bench: Bench) -> None:
    frame = encode(Arm(ARM_KEY), 1)
    for shift in range(10):
        bench.board.write(frame)
        while bench.board.waiting > 1:
            bench.board.run(1e-6)
        bench.board.press_estop(True)
        for _ in range(60):
            bench.board.run(20e-6)
            assert not bench.board.enabled
        bench.board.press_estop(False)
        bench.line.listen(0.005 + shift * 1e-4)
        bench.line.clear_faults()


def test_arm_without_its_key_is_refused(bench: Bench) -> None:
    bench.line.send(Arm(0))
    assert bench.line.listen(0.01)[-1].state == State.IDLE
    assert not bench.board.enabled
