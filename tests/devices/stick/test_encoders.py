"""Counting, on the emulated board: exact at every rate, under glitches and overload."""

from __future__ import annotations

from itertools import pairwise

import pytest
from stick_bench import Bench

RATED = 10_000
"""Edges a second and axis at the velocity trip of x and y (theta: twice that)."""
PRESSING = 16_000
OVERLOAD = 40_000


@pytest.mark.parametrize("rate", [100, 1_000, 5_000, RATED, PRESSING, OVERLOAD])
def test_counts_are_exact_at_any_edge_rate(bench: Bench, rate: int) -> None:
    for targets in ((300, -300, 1440), (-300, 300, -1440), (0, 0, 0)):
        travel = max(abs(t - bench.board.count(i)) for i, t in enumerate(targets))
        for axis, target in enumerate(targets):
            bench.board.turn(axis, target, rate)
        bench.line.listen(min(travel / rate, 0.5) + 0.005)
        while any(bench.board.is_turning(axis) for axis in range(3)):
            bench.line.listen(0.1)
        last = bench.line.listen(0.005)[-1]
        assert last.position == targets
        assert last.glitches == 0


def test_no_tick_is_missed_at_the_rated_speed(bench: Bench) -> None:
    bench.arm(travel=(2047, 2047, 2047))
    bench.line.listen(0.05)
    for axis, rate in enumerate((RATED, RATED, 2 * RATED)):
        bench.board.turn(axis, 1_500, rate - 500)
    heard = bench.line.listen(0.07)
    assert heard[-1].missed == 0
    assert [b.tick - a.tick for a, b in pairwise(heard)] == [1] * 69
    assert heard[-1].faults & 0xFF == 0
    assert heard[-1].signs & 0x20
