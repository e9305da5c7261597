"""What is stored of a live trial beside what happened in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.channel import LatestValue
from omnistudy.view.answer import Answer, Lag
from omnistudy.view.publisher import Publisher


@pytest.mark.parametrize(("trial", "shown"), [(1, True), (2, False)])
def test_the_screen_s_lag_is_stored_with_its_own_trial(
    tmp_path: Path, trial: int, shown: bool
) -> None:
    lag = Lag(trial=1, frames=120, median_ms=20.0, p99_ms=35.0, clock_ms=0.5)
    with (
        LatestValue(tmp_path / "state", 1000) as state,
        LatestValue(tmp_path / "answer", 1000) as answer,
    ):
        answer.write(Answer(lag=lag).model_dump_json().encode())
        told = {
            name: (value, unit) for name, value, unit in Publisher(trial, state, answer).measures()
        }
    screen = {
        "display_frames": (120.0, "1"),
        "display_lag_p50": (0.02, "s"),
        "display_lag_p99": (0.035, "s"),
    }
    assert told == {"late_steps": (0.0, "1")} | (screen if shown else {})
