"""One look at a law: the field's force where the stick is, and how fast it moves."""

from __future__ import annotations

from math import nan
from typing import Literal

import numpy as np
import pytest

from omnistudy.errors.laws import NoForce
from omnistudy.geometry import ZERO_MATRIX, ForceField, PlanarTwist, PlanarWrench, Scan
from omnistudy.laws import Law, Sensed
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.probe import probe

STILL = PlanarTwist(0.0, 0.0, 0.0)
EMPTY = Scan(np.array([0.0]), np.array([0.6]), 0.6)


class Impedance(Law):
    """A field about a place that is not the stick's own."""

    kind: Literal["impedance"] = "impedance"

    def field(self, sensed: Sensed) -> ForceField:
        return ForceField(
            wrench=PlanarWrench(1.0, 2.0, 3.0),
            about=(0.1, 0.0, 0.0),
            stiffness=((10.0, 20.0, 0.0), (0.0, 30.0, 0.0), (0.0, 0.0, 40.0)),
            damping=((1.0, 0.0, 2.0), (0.0, 3.0, 0.0), (4.0, 0.0, 5.0)),
            valid_for=0.05,
        )


class Broken(Law):
    """A law that forgot to look before it divides."""

    kind: Literal["broken"] = "broken"

    def field(self, sensed: Sensed) -> ForceField:
        return ForceField(PlanarWrench(0.0, nan, 0.0))


def test_what_is_felt_is_the_field_at_the_stick() -> None:
    # 0.2 m, 0.1 m and 0.5 rad from where the field holds, moving at 1 m/s, 2 m/s and 3 rad/s.
    sensed = Sensed(EMPTY, STILL, ZERO_MATRIX, stick=(0.3, 0.1, 0.5), stick_rate=(1.0, 2.0, 3.0))
    found = probe(Impedance(), sensed)
    assert found.fx == pytest.approx(1 - (10 * 0.2 + 20 * 0.1) - (1 * 1 + 2 * 3))
    assert found.fy == pytest.approx(2 - 30 * 0.1 - 3 * 2)
    assert found.tau == pytest.approx(3 - 40 * 0.5 - (4 * 1 + 5 * 3))
    assert found.about == (0.1, 0.0, 0.0)
    assert found.stiffness[0] == (10.0, 20.0, 0.0)
    assert found.damping[2] == (4.0, 0.0, 5.0)
    assert (found.valid_for, found.n) == (0.05, None)


def test_rays_that_touch_are_counted() -> None:
    three = Scan(np.array([0.0, 1.0, 3.0]), np.array([0.40, 0.6, 0.30]), 0.6)
    assert probe(ComponentLaw(), Sensed(three, STILL, ZERO_MATRIX)).n == 2
    assert probe(ComponentLaw(), Sensed(EMPTY, STILL, ZERO_MATRIX)).n == 0


def test_a_law_that_gives_no_number_is_named() -> None:
    with pytest.raises(NoForce, match=r"law 'broken' gives fx = 0 N, fy = nan N"):
        probe(Broken(), Sensed(EMPTY, STILL, ZERO_MATRIX))
