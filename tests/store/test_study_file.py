from __future__ import annotations

import hashlib
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import sqlalchemy as sa
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from numpy.typing import NDArray

import omnistudy
from omnistudy.channel import SAMPLE_COLUMNS, Event, Stream
from omnistudy.errors.store import NoSuchStream, NoSuchTrial
from omnistudy.store import (
    Level,
    NewCondition,
    NewParticipant,
    NewStudy,
    NewTrial,
    StudyWriter,
    TrialOutcome,
    open_study,
    sample_digest,
)
from omnistudy.store.rows import insert_samples

FinishTrial = Callable[[StudyWriter, int], None]


def test_trials_are_tidy(driven: Path) -> None:
    with omnistudy.open(driven) as study:
        trials = study.trials()
    assert list(trials["trial"]) == [1, 2, 3, 4, 5, 6]
    assert list(trials["participant"]) == ["P01"] * 3 + ["P02"] * 3
    assert list(trials["participant_kind"]) == ["virtual"] * 3 + ["human"] * 3
    assert list(trials["law"]) == ["component", "none", "component"] * 2
    assert list(trials["status"]) == ["completed"] * 2 + ["planned"] * 4
    assert list(trials["duration_s"].dropna()) == [12.5, 12.5]
    assert list(trials["collisions"].dropna()) == [2.0, 2.0]
    assert trials.attrs["units"]["duration_s"] == "s"
    assert trials.attrs["units"]["path_length_m"] == "m"
    assert set(trials.attrs["units"]) <= set(trials.columns)


def test_a_factor_named_like_a_column_does_not_hide_it(driven: Path) -> None:
    with omnistudy.open(driven) as study:
        trials, conditions = study.trials(), study.conditions()
    assert set(trials["route"]) == {"b"}
    assert set(trials["factor_route"]) == {"long"}
    assert trials.attrs["factors"] == ("law", "factor_route")
    assert list(conditions.columns) == ["condition", "law", "route", "masked_label"]


def test_columns_have_their_types_before_any_trial_was_run(study: Path) -> None:
    with omnistudy.open(study) as opened:
        trials = opened.trials()
    numbers = ["duration_s", "path_length_m", "collisions", "collisions_legacy", "contact_time_s"]
    assert set(trials[numbers].dtypes) == {np.dtype("float64")}
    assert trials["started_at"].isna().all()
    assert str(trials["started_at"].dt.tz) == "UTC"


def test_a_study_without_conditions_can_be_read(tmp_path: Path, new_study: NewStudy) -> None:
    with StudyWriter.create(tmp_path / "bare.db", new_study) as writer:
        session = writer.add_session(
            writer.add_participant(
                NewParticipant(code="P01", kind="virtual", seed="1" * 64), slot=0
            )
        )
        writer.add_trial(
            NewTrial(
                session_id=session, position=1, kind="main", task="reach", route="", seed="2" * 64
            )
        )
    with omnistudy.open(tmp_path / "bare.db") as study:
        assert study.trials()["condition"].isna().all()
        assert len(study.conditions()) == 0
        assert len(study.events()) == 0
        assert len(study.samples(1)) == 0
        assert len(study.streams(1)) == 0


def test_samples_come_back(driven: Path, samples: NDArray[np.float64]) -> None:
    with omnistudy.open(driven) as study:
        frame = study.samples(2)
        array = study.sample_array(2)
    assert list(frame.columns) == list(SAMPLE_COLUMNS)
    assert np.array_equal(frame.to_numpy(), samples, equal_nan=True)
    assert np.array_equal(array, samples, equal_nan=True)
    assert frame.attrs["units"]["tau"] == "N·m"
    assert set(frame.attrs["units"]) == set(SAMPLE_COLUMNS)
    assert set(frame.dtypes) == {np.dtype("float64")}


def test_a_trial_can_be_named_by_the_number_in_a_frame(driven: Path) -> None:
    with omnistudy.open(driven) as study:
        trial = study.trials()["trial"].iloc[0]  # a number of numpy's, not of Python's
        assert len(study.samples(trial)) == len(study.samples(1))
        assert len(study.events(trial)) == len(study.events(1))
        assert list(study.streams(trial)["name"]) == list(study.streams(1)["name"])


def test_events_come_back(driven: Path, events: tuple[Event, ...]) -> None:
    with omnistudy.open(driven) as study:
        every, own = study.events(), study.events(2)
    assert list(every["trial"]) == [1, 1, 1, 2, 2, 2]
    assert [tuple(row) for row in own[["t", "kind", "detail"]].to_numpy()] == list(events)
    assert own.attrs["units"] == {"t": "s"}


def test_streams_come_back(driven: Path, stream: Stream) -> None:
    with omnistudy.open(driven) as study:
        listed = study.streams(1)
        frame = study.stream(1, "input")
        record = study.stream_record(1, "input")
    assert listed.to_dict("records") == [
        {
            "name": "input",
            "rate_hz": 240.0,
            "rows": 10_000,
            "columns": tuple(f"axis_{i}" for i in range(6)),
        }
    ]
    assert list(frame.columns) == ["t", *(f"axis_{i}" for i in range(6))]
    assert frame["t"].iloc[-1] == 9_999 / 240
    assert frame.attrs["units"] == {"t": "s"} | {f"axis_{i}": "m" for i in range(6)}
    assert record.data.tobytes() == stream.data.tobytes()
    assert record[:3] == stream[:3]


def test_streams_without_rows_come_back(
    study: Path,
    finish: FinishTrial,
    outcome: TrialOutcome,
    samples: NDArray[np.float64],
    stream: Stream,
) -> None:
    with StudyWriter.open(study) as writer:
        writer.start_trial(1)
        writer.finish_trial(1, outcome, [], samples, [stream._replace(data=stream.data[:0])])
    with omnistudy.open(study) as opened:
        assert opened.stream_record(1, "input").data.shape == (0, 6)
        assert opened.streams(1)["rows"].tolist() == [0]


def test_people_and_visits(driven: Path) -> None:
    with omnistudy.open(driven) as study:
        participants, sessions = study.participants(), study.sessions()
    assert list(participants["participant"]) == ["P01", "P02"]
    assert list(participants["kind"]) == ["virtual", "human"]
    assert list(sessions["participant"]) == ["P01", "P02"]
    assert list(sessions["status"]) == ["planned", "planned"]


def test_what_is_not_there_is_said(driven: Path) -> None:
    with omnistudy.open(driven) as study:
        for ask in (study.samples, study.events, study.streams):
            with pytest.raises(NoSuchTrial, match="no trial 77"):
                ask(77)
        with pytest.raises(NoSuchStream, match="did you mean 'input'"):
            study.stream(1, "inptu")
        with pytest.raises(NoSuchStream, match="it has none"):
            study.stream(3, "input")


def test_it_introduces_itself(driven: Path) -> None:
    with omnistudy.open(driven) as study:
        assert repr(study) == (
            f"<virtual study 'small': 2 participants, 2 of 6 trials completed, in {driven}>"
        )


@pytest.mark.parametrize(
    "statement",
    ["DELETE FROM trial", "UPDATE study SET title = 'mine'", "CREATE TABLE note (text)"],
)
def test_nothing_can_be_written(driven: Path, statement: str) -> None:
    before = driven.read_bytes()
    with omnistudy.open(driven) as study:
        with pytest.raises(sa.exc.OperationalError, match="readonly"):
            study.connection.exec_driver_sql(statement)
        study.connection.rollback()
        study.connection.exec_driver_sql("PRAGMA query_only = OFF")
        with pytest.raises(sa.exc.OperationalError, match="readonly"):
            study.connection.exec_driver_sql(statement)
    assert driven.read_bytes() == before


def test_reading_leaves_no_trace(driven: Path) -> None:
    before = driven.stat().st_mtime_ns
    with omnistudy.open(driven) as study:
        study.trials()
    assert [entry.name for entry in driven.parent.iterdir()] == ["small.db"]
    assert driven.stat().st_mtime_ns == before


def test_a_reader_sees_what_is_written_meanwhile(study: Path, finish: FinishTrial) -> None:
    with omnistudy.open(study) as opened, StudyWriter.open(study) as writer:
        assert len(opened.events()) == 0
        finish(writer, 1)
        assert len(opened.events()) == 3
        with writer.transaction():
            finish(writer, 2)
            assert len(opened.events()) == 3
        assert len(opened.events()) == 6


def test_one_instant_is_read_as_a_whole(study: Path, finish: FinishTrial) -> None:
    with omnistudy.open(study) as opened, StudyWriter.open(study) as writer:
        with opened.reading():
            assert len(opened.events()) == 0
            finish(writer, 1)
            assert len(opened.events()) == 0
        assert len(opened.events()) == 3


def test_virtual_people_are_visible_to_a_database_browser(driven: Path) -> None:
    with omnistudy.open(driven) as study, study.reading() as connection:
        overview = pd.DataFrame(
            connection.exec_driver_sql("SELECT * FROM trial_overview").mappings().all()
        )
        conditions = connection.exec_driver_sql("SELECT * FROM condition_overview").mappings().all()
    assert list(overview["participant_kind"]) == ["virtual"] * 3 + ["human"] * 3
    assert overview["levels"][0] == "law = component, route = long"
    assert overview["collisions"][1] == 2
    assert [dict(row) for row in conditions] == [
        {
            "condition": name,
            "participant_kind": "virtual",
            "trials": 1,
            "participants": 1,
            "mean_duration_s": 12.5,
            "mean_collisions": 2.0,
            "mean_contact_time_s": 0.75,
        }
        for name in ("with", "without")
    ]


def test_pandas_is_loaded_only_for_frames(driven: Path) -> None:
    code = (
        "import sys, omnistudy\n"
        "with omnistudy.open(sys.argv[1]) as study:\n"
        "    study.sample_array(1), study.stream_record(1, 'input'), repr(study)\n"
        "sys.exit('pandas' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code, driven], check=False).returncode == 0


def test_names_with_special_characters(tmp_path: Path, new_study: NewStudy) -> None:
    path = tmp_path / "100% [odd] #1?é.db"
    with StudyWriter.create(path, new_study) as writer:
        writer.add_conditions([NewCondition(name="a", masked_label="A", levels=(Level("f", "1"),))])
    with omnistudy.open(str(path)) as study:
        assert study.conditions()["f"].tolist() == ["1"]
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]


values = arrays(np.float64, st.tuples(st.integers(0, 6), st.just(12)), elements=st.floats(width=64))


@given(values=values)
@settings(max_examples=30, deadline=None)
def test_any_sample_comes_back(values: NDArray[np.float64]) -> None:
    table = np.column_stack([np.arange(len(values)) / 20, values])
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "one.db"
        study = NewStudy(
            name="one",
            title="",
            kind="virtual",
            protocol_json="{}",
            protocol_version=1,
            design_hash="d" * 64,
            site_hash="e" * 64,
        )
        with StudyWriter.create(path, study) as writer:
            person = NewParticipant(code="P01", kind="virtual", seed="1" * 64)
            session = writer.add_session(writer.add_participant(person, slot=0))
            trial = NewTrial(
                session_id=session, position=1, kind="main", task="t", route="r", seed="2" * 64
            )
            insert_samples(writer.connection, writer.add_trial(trial), table)
        with open_study(path) as opened:
            assert np.array_equal(opened.sample_array(1), table, equal_nan=True)
        # SQLite keeps no sign of a zero; NaN has one form, that of numpy.
        plain = np.where(np.isnan(table), np.nan, table + 0.0)
        rows = np.column_stack([np.ones(len(plain)), plain]).astype("<f8")
        assert sample_digest(path) == hashlib.sha256(rows.tobytes()).hexdigest()
