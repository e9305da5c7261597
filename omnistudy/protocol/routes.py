"""Which trial goes along which route."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def spread_routes(
    routes: Sequence[str], conditions: Sequence[str], row: int, rng: np.random.Generator
) -> tuple[str, ...]:
    """Give each trial a route, so that every condition meets the routes evenly.

    Trials are counted condition by condition, the routes dealt out to them in turn, starting one
    route later from row to row; then those of one condition are shuffled among its trials. So the
    numbers of routes differ by at most one within a participant, within each condition of a
    participant, and for each condition over any rows (Tyagi 2017, sec. 5.1: three
    routes, shuffled).

    conditions : of the trials in time. row : 0-based, of the participant's seat.
    """
    given = [""] * len(conditions)
    dealt = row
    for name in dict.fromkeys(sorted(conditions)):
        places = [place for place, condition in enumerate(conditions) if condition == name]
        drawn = [routes[(dealt + index) % len(routes)] for index in range(len(places))]
        dealt += len(places)
        for place, index in zip(places, rng.permutation(len(places)), strict=True):
            given[place] = drawn[index]
    return tuple(given)
