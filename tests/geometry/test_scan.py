"""Where rays end."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from omnistudy.geometry import Scan

ANGLES = np.array([0.0, pi / 2, pi])
RANGES = np.array([1.0, 2.0, 3.0])


def test_rays_from_the_centre_end_at_their_range() -> None:
    ends = Scan(ANGLES, RANGES, 5.0).points()
    assert ends == pytest.approx(np.array([[1, 0], [0, 2], [-3, 0]]), abs=1e-12)


def test_rays_from_elsewhere_end_as_far_from_there() -> None:
    origins = np.array([[0.2, 0.1], [0.0, 0.18], [-0.2, 0.0]])
    ends = Scan(ANGLES, RANGES, 5.0, origins).points()
    assert ends == pytest.approx(np.array([[1.2, 0.1], [0, 2.18], [-3.2, 0]]), abs=1e-12)
