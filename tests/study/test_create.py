from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

import omnistudy
from omnistudy.errors.store import StudyExists
from omnistudy.errors.study import BadStudyName
from omnistudy.protocol import Protocol, freeze, plan
from omnistudy.protocol.seeds import participant_seed, trial_seed
from omnistudy.study import create_study


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "first.db"


def test_a_study_holds_its_frozen_protocol(component: Protocol, file: Path) -> None:
    record = create_study(component, file, "first")
    frozen = freeze(component)
    assert (record.name, record.kind, record.protocol_version) == ("first", "virtual", 1)
    assert record.protocol_json == frozen.canonical_json
    assert (record.design_hash, record.site_hash) == (frozen.design_hash, frozen.site_hash)


def test_conditions_and_levels_are_written(component: Protocol, file: Path) -> None:
    create_study(component, file, "first")
    with omnistudy.open(file) as study:
        conditions = study.conditions().set_index("condition")
    assert len(conditions) == 6
    assert conditions.loc["none", "feedback"] == "without"
    assert conditions.loc["centre_rear_10", "compliance_centre"] == "-0.1"
    assert conditions.loc["full", "masked_label"] == "B"


def test_every_trial_is_planned_in_its_order(component: Protocol, file: Path) -> None:
    create_study(component, file, "first")
    with omnistudy.open(file) as study:
        trials, people = study.trials(), study.participants()
    assert len(trials) == 80
    assert set(trials["status"]) == {"planned"}
    assert set(trials["protocol_version"]) == {1}
    assert trials["seed"].is_unique
    for slot, code in enumerate(people["participant"]):
        own = trials[trials["participant"] == code].sort_values("position")
        written = list(zip(own["condition"], own["repetition"], own["route"], strict=True))
        planned = [(one.condition, one.repetition, one.route) for one in plan(component, slot)]
        assert written == planned


def test_seeds_can_be_made_again_from_protocol_and_slot(component: Protocol, file: Path) -> None:
    record = create_study(component, file, "first")
    with omnistudy.open(file) as study:
        trials, people = study.trials(), study.participants()
    third = people.iloc[2]
    assert (third["participant"], third["sequence"]) == ("P03", "2")
    assert third["seed"] == participant_seed("utah2017", 2, 1)
    own = trials[(trials["participant"] == "P03") & (trials["position"] == 7)].iloc[0]
    assert own["seed"] == trial_seed(record.design_hash, "utah2017_component", 2, 1, 7, 1)


def test_a_study_that_exists_is_left_alone(component: Protocol, file: Path) -> None:
    create_study(component, file, "first")
    before = file.read_bytes()
    with pytest.raises(StudyExists):
        create_study(component, file, "first")
    assert file.read_bytes() == before


@pytest.mark.parametrize("name", ["", "a b", "../up", ".hidden", "a.b"])
def test_a_name_that_no_file_can_have_is_refused(
    component: Protocol, file: Path, name: str
) -> None:
    with pytest.raises(BadStudyName):
        create_study(component, file, name)
    assert not file.exists()


def test_a_failure_on_the_way_leaves_nothing(
    component: Protocol, file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("omnistudy.study.create.trial_seed", fail)
    with pytest.raises(KeyboardInterrupt):
        create_study(component, file, "first")
    assert list(file.parent.iterdir()) == []


def test_people_are_not_enrolled_by_making_a_study(component: Protocol, file: Path) -> None:
    people = component.participants.model_copy(
        update={"kind": "human", "study_key": "", "participant_key": ""}
    )
    create_study(component.model_copy(update={"participants": people}), file, "first")
    with closing(sqlite3.connect(file)) as database:
        tables = ("participant", "session", "trial")
        counts = [database.execute(f"SELECT count(*) FROM {name}").fetchone()[0] for name in tables]
    assert counts == [0, 0, 0]
