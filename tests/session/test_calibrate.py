"""The driver's skill is found from no-feedback trials alone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import exp, log

import numpy as np
import pytest

from omnistudy.errors.session import CannotCalibrate, NoFreeCondition, NotVirtualDriver
from omnistudy.operators.recorded import RecordedOperator
from omnistudy.protocol import Protocol
from omnistudy.session import calibrate as room
from omnistudy.session.calibrate import calibrate
from omnistudy.session.population import Population, ResponsePoint, Targets
from omnistudy.trial import TrialResult, TrialSpec

LINE = tuple(ResponsePoint(skill, 10.0 * skill, 10) for skill in (1.0, 2.0, 4.0))
"""Ten collisions a unit of skill."""


def test_without_spread_and_practice_the_mean_is_the_response_itself() -> None:
    people = Population(LINE, learning=0.0, seed="s")
    assert people.mean(1.5, 0.0) == pytest.approx(15.0)
    assert people.mean(6.0, 0.0) == pytest.approx(60.0)  # beyond the last point the line goes on
    assert people.log_range(1.5, 0.0) == pytest.approx(0.0)


def test_mean_of_a_log_normal_population_on_a_line_is_known_in_closed_form() -> None:
    people = Population(LINE, learning=0.0, seed="s")
    assert people.mean(1.0, 0.4) == pytest.approx(10.0 * exp(0.4**2 / 2), rel=0.02)


def test_expected_range_of_eight_normals_is_that_of_the_tables() -> None:
    # Expected range of 8 standard normals: 2.847 (Tippett 1925, d2 of control charts).
    people = Population(LINE, learning=0.0, seed="s")
    assert people.log_range(1.0, 0.3) == pytest.approx(0.3 * 2.847, rel=0.03)


def test_practice_is_averaged_over_the_published_places() -> None:
    people = Population(LINE, learning=0.25, seed="s")
    practice = np.mean([place**-0.25 for place in range(1, 7)])
    assert people.mean(2.0, 0.0) == pytest.approx(20.0 * practice)


def test_population_that_is_found_meets_its_targets() -> None:
    people = Population(LINE, learning=0.25, seed="s")
    targets = Targets(mean=34.0, best=17.0, worst=83.0)
    median, spread = people.meeting(targets)
    assert people.mean(median, spread) == pytest.approx(34.0, rel=0.01)
    assert people.log_range(median, spread) == pytest.approx(log(83.0 / 17.0), rel=0.01)


def test_target_out_of_reach_is_said() -> None:
    people = Population((ResponsePoint(1.0, 1.0, 5), ResponsePoint(2.0, 1.0, 5)), 0.0, "s")
    with pytest.raises(CannotCalibrate, match="34 collisions a trial are out of reach"):
        people.meeting(Targets(34.0, 17.0, 83.0))


@pytest.mark.slow
def test_no_trial_with_feedback_is_run(
    short_protocol: Protocol, monkeypatch: pytest.MonkeyPatch
) -> None:
    laws: list[str] = []
    run_all = room.run_all

    def watched(specs: list[TrialSpec], workers: int) -> object:
        laws.extend(spec.law.kind for spec in specs)
        return run_all(specs, workers)

    monkeypatch.setattr(room, "run_all", watched)
    found = calibrate(
        short_protocol,
        Targets(2.0, 1.0, 4.0),
        skills=(2.0, 5.0),
        each=3,
        check=3,
        seed="test",
        workers=1,
    )
    assert set(laws) == {"none"}
    assert len(laws) == 9
    assert found.expected_mean == pytest.approx(2.0, rel=0.02)


@pytest.mark.slow
def test_collisions_are_counted_as_published(
    short_protocol: Protocol, monkeypatch: pytest.MonkeyPatch
) -> None:
    run_all = room.run_all

    def rubbing(specs: list[TrialSpec], workers: int) -> Iterator[TrialResult]:
        for spec, result in zip(specs, run_all(specs, workers), strict=True):
            skill = spec.operator.model_dump()["skill_median"]
            yield replace(result, collisions=0, collisions_legacy=round(4 * skill))

    monkeypatch.setattr(room, "run_all", rubbing)
    found = calibrate(
        short_protocol,
        Targets(8.0, 6.0, 10.0),
        skills=(1.0, 3.0),
        each=3,
        check=3,
        seed="test",
        workers=1,
    )
    assert [point.collisions for point in found.response] == [4.0, 12.0]


def test_protocol_without_a_free_condition_is_refused(short_protocol: Protocol) -> None:
    full = tuple(c for c in short_protocol.conditions if c.name == "full")
    bound = short_protocol.model_copy(update={"conditions": full})
    with pytest.raises(NoFreeCondition, match="no-feedback trials alone"):
        calibrate(bound, Targets(1, 1, 2), skills=(1.0,), each=3, check=3, seed="t", workers=1)


def test_other_operators_are_refused(short_protocol: Protocol) -> None:
    recorded = RecordedOperator.model_construct(kind="recorded")
    other = short_protocol.model_copy(update={"operator": recorded})
    with pytest.raises(NotVirtualDriver, match="'recorded'"):
        calibrate(other, Targets(1, 1, 2), skills=(1.0,), each=3, check=3, seed="t", workers=1)
