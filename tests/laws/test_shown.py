"""What pictures and probes show of laws that are no springs."""

from __future__ import annotations

import pytest
from laws.straight_walls import scan_of

from omnistudy.geometry import ZERO_MATRIX, PlanarTwist
from omnistudy.laws import Sensed
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.impedance_urbano import ImpedanceUrbanoLaw
from omnistudy.laws.none import NoLaw
from omnistudy.laws.probe import probe
from omnistudy.laws.sector_sum import SectorSumLaw
from omnistudy.laws.shown import shown, stick_shown

AHEAD = scan_of([(1.0, 0.0, 0.4)])


def test_a_law_that_pushes_is_shown_at_rest() -> None:
    at_rest = probe(ComponentLaw(), Sensed(AHEAD, PlanarTwist(0.0, 0.0, 0.0), ZERO_MATRIX))
    assert shown(ComponentLaw(), AHEAD) == at_rest
    assert stick_shown(ComponentLaw()) == ""


def test_a_law_that_only_holds_the_stick_is_shown_with_the_stick_ahead() -> None:
    """0.4 of 0.5 m at vmax: 20·(1.2 / 0.64 + 1) = 57.5 N/m on 0.0414 m."""
    found = shown(ImpedanceUrbanoLaw(), AHEAD)
    assert (found.fx, found.fy, found.tau) == pytest.approx((-57.5 * 0.0414, 0.0, 0.0))
    assert stick_shown(ImpedanceUrbanoLaw()) == ", stick held full ahead"


def test_the_rays_inside_are_counted_for_every_law_with_a_boundary() -> None:
    """A wall at 0.4 m is inside the circle of 0.5 m up to 36.9 degrees: 13 rays to each side."""
    assert shown(SectorSumLaw(), AHEAD).n == 27
    assert shown(ImpedanceUrbanoLaw(), AHEAD).n == 27
    assert shown(NoLaw(), AHEAD).n is None
