"""Lag is from a state to its frame, by the session's clock."""

from __future__ import annotations

import pytest

from omnistudy.view.screen_lag import ScreenLag


def test_median_and_p99_are_those_of_the_frames() -> None:
    screen = ScreenLag()
    for place in range(1, 101):
        screen.drew(7, made=10.0, at=10.0 + place / 1000, within=0.001 if place == 3 else 0.0002)
    lag = screen.lag()
    assert (lag.trial, lag.frames) == (7, 100)
    assert lag.median_ms == pytest.approx(50.5)
    assert lag.p99_ms == pytest.approx(100.0)
    assert lag.clock_ms == pytest.approx(1.0)


def test_another_trial_begins_anew() -> None:
    screen = ScreenLag()
    screen.drew(1, made=0.0, at=5.0, within=1.0)
    screen.drew(2, made=6.0, at=6.02, within=0.0)
    lag = screen.lag()
    assert (lag.trial, lag.frames, lag.clock_ms) == (2, 1, 0.0)
    assert lag.median_ms == lag.p99_ms == pytest.approx(20.0)
