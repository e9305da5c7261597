"""Counting, on the emulated board: exact at every rate, under glitches and overload."""

from __future__ import annotations

import pytest
from stick_bench import Bench

RATED = 10_000
"""Edges a second and axis at the velocity trip."""
PRESSING = 16_000
OVERLOAD = 40_000


@pytest.mark.parametrize("rate", [1_000, 5_000, RATED, PRESSING, OVERLOAD])
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


@pytest.mark.parametrize("line", [0, 1])
def test_a_short_pulse_on_a_line_is_no_step(bench: Bench, line: int) -> None:
    bench.board.turn(0, 50, 2_000)
    bench.line.listen(0.05)
    for microseconds in (0.5, 2, 10, 40, 200):
        bench.board.glitch(0, line, microseconds * 1e-6)
        bench.line.listen(0.003)
    assert bench.line.listen(0.002)[-1].position == (50, 0, 0)
    bench.board.turn(0, 0, 2_000)
    assert bench.line.listen(0.05)[-1].position == (0, 0, 0)


def test_glitches_while_turning_are_seen_or_do_no_harm(bench: Bench) -> None:
    bench.board.turn(1, 1000, RATED)
    for _ in range(60):
        bench.board.glitch(1, 0, 3e-6)
        bench.line.listen(0.0017)
    last = bench.line.listen(0.02)[-1]
    assert abs(last.position[1] - 1000) <= 2 * last.glitches


def test_a_lost_step_is_counted_as_illegal(bench: Bench) -> None:
    bench.board.jump(2)
    assert bench.line.listen(0.005)[-1].glitches == 1
