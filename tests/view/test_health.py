"""What the loop of a live trial says about itself."""

from __future__ import annotations

from omnistudy.view.health import LoopHealth, Reading


def test_a_late_step_is_to_be_looked_at_for_five_seconds() -> None:
    loop = LoopHealth()
    looks = [loop.readings(t, late, 0.0)[0] for t, late in ((0, 0), (1, 2), (6, 2), (6.1, 2))]
    assert [(one.value, one.ok) for one in looks] == [(0, True), (2, False), (2, False), (2, True)]


def test_being_ahead_of_the_clock_is_not_being_behind() -> None:
    behind = [LoopHealth().readings(1.0, 0, seconds)[1] for seconds in (-0.004, 0.01, 0.06)]
    assert [one.value for one in behind] == [0.0, 10.0, 60.0]
    assert [one.ok for one in behind] == [True, True, False]
    assert behind[0] == Reading("behind the clock", 0.0, "ms", True)
