"""What the loop of a live trial says about itself."""

from __future__ import annotations

from omnistudy.channel import measured
from omnistudy.view.health import LoopHealth, Reading, device_health


def test_a_late_step_is_to_be_looked_at_for_five_seconds() -> None:
    loop = LoopHealth()
    looks = [loop.readings(t, late, 0.0)[0] for t, late in ((0, 0), (1, 2), (6, 2), (6.1, 2))]
    assert [(one.value, one.ok) for one in looks] == [(0, True), (2, False), (2, False), (2, True)]


def test_being_ahead_of_the_clock_is_not_being_behind() -> None:
    behind = [LoopHealth().readings(1.0, 0, seconds)[1] for seconds in (-0.004, 0.01, 0.06)]
    assert [one.value for one in behind] == [0.0, 10.0, 60.0]
    assert [one.ok for one in behind] == [True, True, False]
    assert behind[0] == Reading("behind the clock", 0.0, "ms", True)


def test_of_a_device_only_what_somebody_may_have_to_look_at_is_shown() -> None:
    told = (
        measured("device_ticks", 1000),
        measured("dropped_frames", 1),
        measured("turn_lateness_p99", 0.002),
        measured("saturated_stick_x", 0.3),
        measured("late_fields", 0),
    )
    assert device_health(told) == (
        Reading("dropped frames", 1.0, "", False),
        Reading("turn lateness p99", 2.0, "ms", True),
        Reading("saturated stick x", 0.3, "", False),
        Reading("late fields", 0.0, "", True),
    )
