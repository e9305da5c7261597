"""What leads an arm, as numbers of a device and back."""

from __future__ import annotations

from math import isnan, nan

import numpy as np
import pytest

from omnistudy.arm.guidance import Guidance
from omnistudy.errors.arm import BadGuidance
from omnistudy.geometry import PlanarPose

TWIST = np.array((0.01, 0.02, 0.03, 0.04, 0.05, 0.06))
BACK = np.array((0.001, 0.0, 0.0, 0.0, 0.0, 0.002))


@pytest.mark.parametrize(
    ("guidance", "count"),
    [
        (Guidance(TWIST), 6),
        (Guidance(TWIST, 0.3), 7),
        (Guidance(TWIST, nan, PlanarPose(1.0, 2.0, 3.0)), 10),
        (Guidance(TWIST, correction=BACK), 18),
        (Guidance(TWIST, 0.3, PlanarPose(1.0, 2.0, 3.0), (0.1, -0.2), BACK, np.arange(7.0)), 25),
    ],
)
def test_every_guidance_comes_back_from_its_numbers(guidance: Guidance, count: int) -> None:
    assert len(guidance.numbers) == count
    back = Guidance.read(guidance.numbers)
    assert back.numbers == pytest.approx(guidance.numbers, nan_ok=True)
    assert (back.chair_goal, back.chair_rates) == (guidance.chair_goal, guidance.chair_rates)
    assert (back.posture is None) == (guidance.posture is None)
    assert isnan(back.bearing) == isnan(guidance.bearing)


@pytest.mark.parametrize("count", [0, 5, 8, 12, 17])
def test_another_count_of_numbers_is_refused(count: int) -> None:
    with pytest.raises(BadGuidance, match=f"led by {count} numbers"):
        Guidance.read((0.0,) * count)
