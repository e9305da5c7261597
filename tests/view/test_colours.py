"""Colours that carry meaning are told apart by colour-blind eyes too."""

from __future__ import annotations

import json
from itertools import combinations
from pathlib import Path

import pytest
from view.colour_difference import EYES, difference, seen

COLOURS = Path(__file__).parents[2] / "front" / "src" / "colours.json"
APART = 10.0


@pytest.mark.parametrize(
    ("one", "other", "published"),
    [
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, 2.5, 0.0), (58.0, 24.0, 15.0), 19.4535),
        ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
    ],
)
def test_differences_are_those_that_sharma_published(
    one: tuple[float, float, float], other: tuple[float, float, float], published: float
) -> None:
    assert difference(one, other) == pytest.approx(published, abs=5e-5)


@pytest.mark.parametrize("eyes", EYES)
def test_every_pair_of_series_colours_is_far_apart(eyes: str) -> None:
    colours = json.loads(COLOURS.read_text(encoding="utf-8"))
    apart = {
        pair: difference(seen(colours[pair[0]], eyes), seen(colours[pair[1]], eyes))
        for pair in combinations(colours, 2)
    }
    assert {pair: round(value, 1) for pair, value in apart.items() if value < APART} == {}
