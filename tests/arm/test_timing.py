"""How much of a path is done by when."""

from __future__ import annotations

from math import sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from omnistudy.arm.timing import Timing

timings = st.one_of(
    st.builds(Timing, law=st.sampled_from(["linear", "cubic"])),
    st.builds(Timing, law=st.just("blended"), blending=st.floats(1.0, 1000.0)),
)
shares = st.floats(0.0, 1.0)


@given(timings)
def test_it_begins_and_ends_where_it_should(timing: Timing) -> None:
    assert timing.share(0.0) == 0.0
    assert timing.share(1.0) == pytest.approx(1.0)
    assert timing.share(0.5) == pytest.approx(0.5)


@given(timings, shares, shares)
def test_it_never_goes_back(timing: Timing, one: float, other: float) -> None:
    early, late = sorted((one, other))
    assert timing.share(early) <= timing.share(late) + 1e-12


@given(timings, st.floats(0.001, 0.999))
def test_its_rate_is_its_slope_and_never_above_its_peak(timing: Timing, u: float) -> None:
    h = 1e-6
    slope = (timing.share(u + h) - timing.share(u - h)) / (2 * h)
    # at the ends of a blend the slope has a corner
    assert timing.rate(u) == pytest.approx(slope, abs=4.0 * timing.blending * h + 1e-6)
    assert timing.rate(u) <= timing.peak + 1e-12


def test_the_labs_blend() -> None:
    # b = 5: blends of 5.279 % of the time, cruising at 1.0557 times the mean speed
    timing = Timing()
    assert timing.peak == pytest.approx(1.0557, abs=5e-5)
    assert timing.share(0.05279) == pytest.approx(0.5 * 1.0557 * 0.05279, abs=1e-5)
    assert timing.share(0.25) == pytest.approx(1.0557 * (0.25 - 0.5 * 0.05279), abs=1e-4)


def test_known_values() -> None:
    assert Timing(law="cubic").share(0.25) == 0.15625
    assert Timing(law="cubic").peak == Timing(law="cubic").rate(0.5) == 1.5
    assert Timing(blending=1.0).share(0.25) == 0.125
    assert Timing(blending=1.0).peak == 2.0
    assert Timing(blending=2.0).peak == pytest.approx(4.0 * (1.0 - sqrt(0.5)))
    assert Timing(law="linear").share(0.3) == 0.3


def test_a_blend_below_one_has_no_solution_and_is_refused() -> None:
    with pytest.raises(ValidationError, match="greater than or equal to 1"):
        Timing(blending=0.5)
