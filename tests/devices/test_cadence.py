"""Lateness is counted in one process and summed up in another."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.devices.cadence import Cadence


def test_quantiles_of_known_lateness(tmp_path: Path) -> None:
    counting = Cadence(tmp_path / "cadence", make=True)
    counting.begin(7)
    for late in [0.00005] * 97 + [0.0015, 0.003, 0.2]:
        counting.count(late)
    told = Cadence(tmp_path / "cadence").lateness(7, period=0.001)
    assert told is not None
    assert (told.turns, told.late) == (100, 3)
    assert told.median == pytest.approx(0.00005, abs=2e-5)
    assert told.p99 == pytest.approx(0.003, abs=2e-5)
    assert told.greatest == pytest.approx(0.2, abs=2e-5)


def test_each_trial_is_counted_anew(tmp_path: Path) -> None:
    cadence = Cadence(tmp_path / "cadence", make=True)
    cadence.begin(1)
    cadence.count(0.01)
    cadence.begin(2)
    assert cadence.lateness(2, 0.001) is None
    cadence.count(0.0)
    assert cadence.lateness(1, 0.001) is None
    told = cadence.lateness(2, 0.001)
    assert told is not None
    assert (told.turns, told.late, told.greatest) == (1, 0, 0.0)
