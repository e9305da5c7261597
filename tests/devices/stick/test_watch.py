"""What the watch holds for trouble and what not, frame by frame."""

from __future__ import annotations

import pytest

from omnistudy.devices.stick.messages import Identity, State, Telemetry, Three
from omnistudy.devices.stick.watch import Expected, Watch

STICK = Identity(1, 1, 0xABCD, 5)
EXPECTED = Expected(STICK, (300, 300, 1440), (255, 255, 255))


def told(
    tick: int, position: Three = (0, 0, 0), motor: Three = (0, 0, 0), state: State = State.FORCE
) -> Telemetry:
    return Telemetry(tick, position, (0, 0, 0), motor, state, 0, 0, 0, 0, 0, 0, 0, 0, 0)


def watched(frames: list[Telemetry]) -> str:
    """Give each frame to a watch in its own millisecond."""
    watch = Watch(EXPECTED, frames[0].tick / 1000)
    for frame in frames:
        watch.look([frame], frame.tick / 1000)
    return watch.trouble


def test_a_hand_that_holds_still_is_no_frozen_encoder() -> None:
    assert watched([told(tick, (20, 0, 0), (50, 0, 0)) for tick in range(3000)]) == ""


def test_a_jump_of_force_needs_time_to_move_anything() -> None:
    quick = [told(tick, motor=(0, 0, 0)) for tick in range(60)]
    quick += [told(tick, motor=(0, 100, 0)) for tick in range(60, 90)]
    moved = [told(tick, (0, 1, 0), (0, 100, 0)) for tick in range(90, 180)]
    assert watched(quick + moved) == ""
    still = [told(tick, motor=(0, 100, 0)) for tick in range(90, 110)]
    assert "encoder of y stands still while its force changed by 100" in watched(quick + still)


def test_sixty_steps_of_force_are_not_enough() -> None:
    frames = [told(tick, motor=(0, 0, 30 if tick % 2 else -30)) for tick in range(1000)]
    assert watched(frames) == ""


def test_a_stick_held_against_its_stop_is_no_frozen_encoder() -> None:
    frames = [told(tick, (-290, 0, 0), (tick % 200, 0, 0)) for tick in range(1000)]
    assert watched(frames) == ""


@pytest.mark.parametrize(("counts", "told_so"), [(315, False), (316, True)])
def test_how_far_beyond_its_stop_a_stick_may_tell(counts: int, told_so: bool) -> None:
    assert bool(watched([told(tick, (counts, 0, 0)) for tick in range(10)])) == told_so


def test_frames_that_a_busy_host_lost_are_no_fault_of_the_stick() -> None:
    watch = Watch(EXPECTED, 0.0)
    for tick in range(1000):
        if 100 <= tick < 400:
            continue  # nobody looked, and the port's buffer ran over
        watch.look([told(tick)], tick / 1000)
    assert watch.trouble == ""
    for tick in range(1000, 2000):
        watch.look([told(tick)] if tick % 10 < 7 else [], tick / 1000)
    assert "only 70% of its telemetry came" in watch.trouble


def test_the_reason_of_a_new_start_is_waited_for_a_moment() -> None:
    watch = Watch(EXPECTED, 0.0)
    watch.look([told(500)], 0.001)
    assert watch.look([told(3, state=State.IDLE)], 0.002) == ""
    assert watch.asks
    assert watch.meet(STICK._replace(reset_cause=8)) == "the stick started anew (its watchdog)"


def test_a_new_start_without_a_reason_is_told_too() -> None:
    watch = Watch(EXPECTED, 0.0)
    watch.look([told(500)], 0.001)
    watch.look([told(3, state=State.IDLE)], 0.002)
    assert watch.look([told(24, state=State.IDLE)], 0.023) == "the stick started anew"


def test_another_stick_is_known_by_its_number_or_its_firmware() -> None:
    assert Watch(EXPECTED, 0.0).meet(STICK) == ""
    assert "serial number 6" in Watch(EXPECTED, 0.0).meet(STICK._replace(serial=6))
    assert "firmware 0000abce" in Watch(EXPECTED, 0.0).meet(STICK._replace(firmware=0xABCE))


def test_what_was_found_first_is_said_for_good() -> None:
    watch = Watch(EXPECTED, 0.0)
    first = watch.look([told(1, state=State.IDLE)], 0.001)
    assert "state IDLE" in first
    assert watch.look([told(2, (999, 0, 0))], 0.002) == first
    assert watch.meet(STICK._replace(serial=6)) == first
