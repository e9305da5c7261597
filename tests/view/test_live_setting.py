"""What the monitor knows of a trial before its first state."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.errors.store import NoSuchTrial
from omnistudy.view.live_setting import live_setting


def test_it_says_where_the_trial_stands_and_what_is_still_planned(driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        setting = live_setting(study, 2)
        trials = study.trials()
    assert (setting.visit, setting.place, setting.places) == (1, 2, len(trials))
    assert (setting.participant, setting.kind, setting.route) == ("P01", "main", "through")
    assert [coming.place for coming in setting.coming] == list(range(3, len(trials) + 1))
    assert {coming.expected_s for coming in setting.coming} == {setting.expected_s}
    assert setting.pause_s == 60.0


def test_the_boundary_is_the_law_s_and_absent_where_nothing_pushes(driven_study: Path) -> None:
    """Tyagi 2017, sec. 4.1: the youBot's half sizes 0.29 and 0.19 m and layers 0.15 and 0.12 m."""
    with omnistudy.open(driven_study) as study:
        named = study.trials().set_index("condition")["trial"]
        assert live_setting(study, int(named["none"])).boundary == ()
        outline = np.array(live_setting(study, int(named["full"])).boundary)
    assert np.abs(outline).max(axis=0) == pytest.approx([0.44, 0.31])


def test_the_last_trial_has_nothing_after_it_and_others_are_unknown(driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        last = int(study.trials()["trial"].max())
        assert live_setting(study, last).coming == ()
        with pytest.raises(NoSuchTrial, match="no trial 99"):
            live_setting(study, 99)
