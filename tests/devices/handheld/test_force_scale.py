"""From what an instrument read of each push to a full effect's newtons."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.handheld.force_effects import Strength
from omnistudy.devices.handheld.force_scale import (
    FullForce,
    Push,
    PushRead,
    full_force,
    measured,
    pushes,
)
from omnistudy.errors.handheld import NoForceFelt


def test_each_axis_is_pushed_both_ways_ever_stronger() -> None:
    assert pushes((1,), 2) == (
        Push(1, 0.0), Push(1, 0.5), Push(1, -0.5), Push(1, 1.0), Push(1, -1.0),
    )  # fmt: skip
    assert len(pushes((0, 1), 4)) == 18


@given(st.floats(0.5, 20.0), st.floats(-1, 1), st.floats(-1, 1), st.booleans())
def test_exact_readings_give_the_force_whatever_the_instrument_s_zeros(
    full: float, zero_x: float, zero_y: float, turned: bool
) -> None:
    sign = -1.0 if turned else 1.0
    reads = [
        PushRead(push, (zero_x, zero_y)[push.axis] + sign * full * push.share)
        for push in pushes((0, 1), 3)
    ]
    found = full_force(reads, turned=False)
    assert found.force == pytest.approx(full)
    assert found.half_width == pytest.approx(0.0, abs=1e-6)
    assert found.turned is turned
    assert full_force(reads, turned=True).turned is not turned


def test_an_interval_worked_out_by_hand() -> None:
    # Readings 0.1, 4.1, -3.9, 8.3, -8.1 of 0, +-1/2, +-1: slope 20.4/2.5 = 8.16, mean 0.1; the
    # residuals 0, -0.08, 0.08, 0.04, -0.04 have a variance of 0.016/3, Student's t of 3 is 3.1824.
    reads = [
        PushRead(push, force)
        for push, force in zip(pushes((0,), 2), (0.1, 4.1, -3.9, 8.3, -8.1), strict=True)
    ]
    found = full_force(reads, turned=False)
    assert found.force == pytest.approx(8.16)
    assert found.half_width == pytest.approx(3.1824 * (0.016 / 3 / 2.5) ** 0.5, rel=1e-4)


def test_readings_that_do_not_grow_are_refused() -> None:
    reads = [PushRead(push, 0.01 * n) for n, push in enumerate(pushes((0, 1), 2))]
    with pytest.raises(NoForceFelt, match="do not grow with the pushes"):
        full_force(reads, turned=False)


def test_what_was_found_stands_in_the_strength() -> None:
    strength = measured(Strength(gain=0.5), FullForce(4.1234, 0.21, False), "today, scale")
    assert strength == Strength(
        force=4.123, gain=0.5, measured="today, scale; ± 0.21 N (95 %)", turned=False
    )
