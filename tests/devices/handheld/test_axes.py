"""From an axis's number to the stick's position."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from omnistudy.controllers.rate import RateController
from omnistudy.devices.handheld.axes import AxisMap, AxisRange, HardwareAxis, Travel
from omnistudy.errors.handheld import NoSuchAxis

LEVER = HardwareAxis("lever", -100.0, 0.0, 100.0)
UP, DOWN = HardwareAxis("up", 0.0, 0.0, 1.0), HardwareAxis("down", 0.0, 0.0, 1.0)
maps = st.builds(
    AxisMap,
    axis=st.just("lever"),
    sign=st.sampled_from((-1, 1)),
    dead_zone=st.floats(0.0, 0.9),
    exponent=st.floats(0.25, 4.0),
)


def deflection(axis: AxisMap, raw: float) -> float:
    return axis.on((LEVER,)).deflection((raw,))


@given(maps, st.floats(-150.0, 150.0))
def test_both_ways_are_alike(axis: AxisMap, raw: float) -> None:
    assert deflection(axis, -raw) == -deflection(axis, raw)


@given(maps, st.floats(-150.0, 150.0), st.floats(-150.0, 150.0))
def test_further_is_never_less(axis: AxisMap, one: float, other: float) -> None:
    low, high = sorted((one, other))
    assert axis.sign * deflection(axis, low) <= axis.sign * deflection(axis, high)


@given(maps, st.floats(-1.0, 1.0))
def test_nothing_in_the_dead_zone(axis: AxisMap, share: float) -> None:
    assert deflection(axis, 100.0 * axis.dead_zone * share) == 0.0


@given(maps, st.floats(100.0, 1e6))
def test_full_at_the_end_and_beyond(axis: AxisMap, raw: float) -> None:
    assert deflection(axis, raw) == axis.sign


def test_a_dead_zone_shifts_and_an_exponent_bends() -> None:
    # 60 of 100 with a dead zone of 20: half of the way that is left; squared a quarter
    assert deflection(AxisMap(axis="lever", dead_zone=0.2), 60.0) == pytest.approx(0.5)
    bent = AxisMap(axis="lever", dead_zone=0.2, exponent=2.0)
    assert deflection(bent, -60.0) == pytest.approx(-0.25)


def test_a_calibrated_range_with_its_rest_off_the_middle() -> None:
    axis = AxisMap(axis="lever", range=AxisRange(low=-80, centre=10, high=50))
    found = [deflection(axis, raw) for raw in (-80.0, -35.0, 10.0, 30.0, 50.0)]
    assert found == pytest.approx([-1.0, -0.5, 0.0, 0.5, 1.0])


def test_two_buttons_or_triggers_make_an_axis() -> None:
    pair = AxisMap(axis="up", opposite="down").on((DOWN, UP))
    assert [pair.deflection(raw) for raw in ((0, 1), (1, 0), (1, 1), (0, 0.5))] == [1, -1, 0, 0.5]


def test_full_deflection_is_full_speed() -> None:
    # omni.md 2: 0.36 m/s and 1.2 rad/s at most; half of the twist is half of the speed
    travel = Travel()
    full = RateController().intent((travel.x, -travel.y, travel.theta))
    assert tuple(full) == pytest.approx((0.36, -0.36, 1.2))
    half = RateController().intent((0.5 * travel.x, 0.0, 0.5 * travel.theta))
    assert tuple(half) == pytest.approx((0.18, 0.0, 0.6))


def test_an_axis_that_is_not_there_is_one_sentence() -> None:
    with pytest.raises(NoSuchAxis, match=r"no axis 'levr': it has lever; did you mean 'lever'\?"):
        AxisMap(axis="levr").on((LEVER,))


def test_a_range_must_rise_and_a_pair_has_none() -> None:
    with pytest.raises(ValidationError, match="must rise"):
        AxisRange(low=5, centre=0, high=10)
    with pytest.raises(ValidationError, match="a pair of axes has none"):
        AxisMap(axis="up", opposite="down", range=AxisRange(low=0, centre=0, high=1))
