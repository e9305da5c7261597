from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

import omnistudy
from omnistudy.errors.study import UnknownParticipant
from omnistudy.protocol import Protocol, plan
from omnistudy.study import create_study, plan_session


def test_a_participants_trials_come_with_their_times(component: Protocol, tmp_path: Path) -> None:
    create_study(component, tmp_path / "a.db", "a")
    with omnistudy.open(tmp_path / "a.db") as study:
        planned = plan_session(study, "P02")
    assert [one.condition for one in planned] == [one.condition for one in plan(component, 1)]
    assert [one.position for one in planned] == list(range(1, 11))
    assert planned[0].start_s == 0.0
    for before, after in pairwise(planned):
        assert after.start_s == pytest.approx(before.start_s + before.duration_s + 60.0)


def test_an_unknown_participant_is_answered_with_the_codes(
    component: Protocol, tmp_path: Path
) -> None:
    create_study(component, tmp_path / "a.db", "a")
    with (
        omnistudy.open(tmp_path / "a.db") as study,
        pytest.raises(UnknownParticipant, match=r"P01, P02.*did you mean 'P01'"),
    ):
        plan_session(study, "P1")
