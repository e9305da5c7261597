"""Noise with a memory: unit variance, and it forgets at the rate that it promises."""

from math import exp

import numpy as np
import pytest

from omnistudy.operators.noise import OrnsteinUhlenbeck
from omnistudy.seeds import generator

STEPS = 200_000


@pytest.mark.parametrize(("time_constant", "dt"), [(1.5, 0.05), (0.2, 0.05)])
def test_variance_and_memory(time_constant: float, dt: float) -> None:
    noise = OrnsteinUhlenbeck(generator("noise", "test"), time_constant, dt)
    values = np.array([noise.step() for _ in range(STEPS)])
    independent = STEPS * dt / (2 * time_constant)
    slack = 4 / independent**0.5  # four standard errors
    assert values.mean() == pytest.approx(0.0, abs=slack)
    assert values.var() == pytest.approx(1.0, abs=2 * slack)
    for lag in (1, 5, 20):
        together = float(np.mean(values[:-lag] * values[lag:]))
        assert together == pytest.approx(exp(-lag * dt / time_constant), abs=2 * slack)


def test_it_begins_as_spread_as_it_goes_on() -> None:
    rng = generator("noise", "begin")
    first = np.array([OrnsteinUhlenbeck(rng, 1.5, 0.05).value for _ in range(20_000)])
    assert first.std() == pytest.approx(1.0, abs=0.02)
