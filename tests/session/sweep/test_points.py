from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors.sweep import IntervalNeedsSamples, SamplesNeedInterval
from omnistudy.session.sweep.points import combinations, require_interval, sobol
from omnistudy.session.sweep.variables import read_words

LISTS = read_words(["a=1,2", "b=x,y,z", "operator.c=5,6"]).swept
BOTH = read_words(["a=1,2", "b=interval(0,1)", "c=interval(10,20)"]).swept


def test_lists_are_crossed_role_by_role() -> None:
    designs = combinations(LISTS, "design", None, "seed")
    assert [tuple(one.values()) for one in designs] == [
        (1, "x"), (1, "y"), (1, "z"), (2, "x"), (2, "y"), (2, "z"),
    ]  # fmt: skip
    assert combinations(LISTS, "nuisance", None, "seed") == ({"operator.c": 5}, {"operator.c": 6})


def test_a_role_without_a_variable_has_one_empty_combination() -> None:
    assert combinations(read_words(["a=1,2"]).swept, "nuisance", None, "seed") == ({},)


def test_intervals_are_sampled_together_and_crossed_with_lists() -> None:
    designs = combinations(BOTH, "design", 3, "seed")
    pairs = [(one["b"], one["c"]) for one in designs]
    assert [one["a"] for one in designs] == [1, 1, 1, 2, 2, 2]
    assert pairs[:3] == pairs[3:]
    assert len(set(pairs)) == 3


@given(st.integers(1, 70), st.integers(1, 4))
def test_a_sobol_sequence_fills_every_dimension_evenly(samples: int, dimensions: int) -> None:
    """Of the first 2^k points every slice of width 2^-k holds exactly one."""
    drawn = sobol(dimensions, samples, "seed")
    assert drawn.shape == (samples, dimensions)
    whole = 2 ** (samples.bit_length() - 1)
    slices = np.sort(np.floor(drawn[:whole] * whole).astype(int), axis=0)
    assert (slices == np.arange(whole)[:, None]).all()


def test_the_stored_seed_decides_what_is_drawn() -> None:
    assert (sobol(2, 8, "one") == sobol(2, 8, "one")).all()
    assert (sobol(2, 8, "one") != sobol(2, 8, "another")).any()


@given(st.integers(-20, 20), st.integers(1, 30))
def test_whole_numbers_come_from_end_to_end(low: int, width: int) -> None:
    swept = read_words([f"a=int(interval({low},{low + width}))"]).swept
    drawn = [one["a"] for one in combinations(swept, "design", 8 * (width + 1), "seed")]
    assert set(drawn) == set(range(low, low + width + 1))


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6))
def test_a_sampled_value_lies_in_its_interval_and_is_short(low: float, width: float) -> None:
    swept = read_words([f"a=interval({low!r},{low + width!r})"]).swept
    for one in combinations(swept, "design", 4, "seed"):
        assert low <= one["a"] <= low + width
        assert one["a"] in (low, low + width) or float(f"{one['a']:.6g}") == one["a"]


def test_an_interval_needs_samples_and_samples_need_an_interval() -> None:
    with pytest.raises(IntervalNeedsSamples, match="b is an interval: say with --samples"):
        combinations(BOTH, "design", None, "seed")
    with pytest.raises(SamplesNeedInterval, match="no key is an interval"):
        require_interval(LISTS, 4)
