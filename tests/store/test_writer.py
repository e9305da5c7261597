from __future__ import annotations

import hashlib
import sqlite3
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from sqlalchemy.exc import IntegrityError

import omnistudy
from omnistudy.channel import Event, Stream
from omnistudy.errors.store import NoSuchTrial, StudyBusy, StudyExists, WrongTrialStatus
from omnistudy.store import (
    NewParticipant,
    NewStudy,
    NewTrial,
    StudyWriter,
    TrialOutcome,
    open_study,
    sample_digest,
    upgrade_study,
)

FinishTrial = Callable[[StudyWriter, int], None]


def rows(path: Path, query: str) -> list[tuple[object, ...]]:
    database = sqlite3.connect(path)
    try:
        return database.execute(query).fetchall()
    finally:
        database.close()


def test_new_study_is_one_wal_file_with_foreign_keys(study: Path) -> None:
    assert [entry.name for entry in study.parent.iterdir()] == ["small.db"]
    assert rows(study, "PRAGMA journal_mode") == [("wal",)]
    with StudyWriter.open(study) as writer:
        assert writer.connection.exec_driver_sql("PRAGMA foreign_keys").scalar() == 1
        assert writer.connection.exec_driver_sql("PRAGMA synchronous").scalar() == 2


def test_study_row_says_what_it_is(study: Path, new_study: NewStudy) -> None:
    with StudyWriter.open(study) as writer:
        stored = writer.study
    assert stored.protocol_json == new_study.protocol_json
    assert (stored.name, stored.kind) == ("small", "virtual")
    assert (stored.design_hash, stored.site_hash) == ("d" * 64, "e" * 64)
    assert stored.omnistudy_version == omnistudy.__version__
    assert stored.created_at.utcoffset() == timedelta(0)
    assert abs(stored.created_at - datetime.now(UTC)) < timedelta(minutes=5)


def test_a_path_that_is_taken_is_left_alone(tmp_path: Path, new_study: NewStudy) -> None:
    path = tmp_path / "mine.db"
    path.write_text("precious")
    with pytest.raises(StudyExists, match="never overwritten"), StudyWriter.create(path, new_study):
        pass
    assert path.read_text() == "precious"


def test_a_file_that_appears_meanwhile_is_left_alone(tmp_path: Path, new_study: NewStudy) -> None:
    path = tmp_path / "mine.db"

    def create() -> None:
        with StudyWriter.create(path, new_study):
            path.write_text("precious")

    with pytest.raises(StudyExists):
        create()
    assert path.read_text() == "precious"
    assert [entry.name for entry in tmp_path.iterdir()] == ["mine.db"]


def test_creation_is_whole_or_not_at_all(tmp_path: Path, new_study: NewStudy) -> None:
    def fail_half_way() -> None:
        with StudyWriter.create(tmp_path / "half.db", new_study) as writer:
            writer.add_participant(
                NewParticipant(code="P01", kind="virtual", seed="1" * 64), slot=0
            )
            raise KeyError("something else went wrong")

    with pytest.raises(KeyError):
        fail_half_way()
    assert list(tmp_path.iterdir()) == []


def test_creation_makes_the_folder(tmp_path: Path, new_study: NewStudy) -> None:
    with StudyWriter.create(tmp_path / "studies" / "new.db", new_study):
        pass
    with open_study(tmp_path / "studies" / "new.db") as study:
        assert study.study.title == "A small study"


def test_transactions_keep_all_or_nothing(study: Path) -> None:
    def fail_half_way(writer: StudyWriter) -> None:
        with writer.transaction():
            writer.add_participant(
                NewParticipant(code="P03", kind="virtual", seed="3" * 64), slot=2
            )
            raise KeyError("something else went wrong")

    with StudyWriter.open(study) as writer:
        with pytest.raises(KeyError):
            fail_half_way(writer)
        writer.add_participant(NewParticipant(code="P04", kind="virtual", seed="4" * 64), slot=3)
    assert rows(study, "SELECT code FROM participant") == [("P01",), ("P02",), ("P04",)]


def test_planned_trials_come_in_order(study: Path) -> None:
    with StudyWriter.open(study) as writer:
        trials = writer.planned_trials()
        second = writer.planned_trials(participant="P02")
    assert [(trial.participant_code, trial.position) for trial in trials] == [
        ("P01", 1),
        ("P01", 2),
        ("P01", 3),
        ("P02", 1),
        ("P02", 2),
        ("P02", 3),
    ]
    assert [trial.id for trial in second] == [4, 5, 6]
    first = second[0]
    assert first.participant_kind == "human"
    assert first.participant_seed == "2" * 64
    assert (first.visit, first.attempt, first.condition, first.route) == (1, 1, "with", "b")
    assert (first.seed, first.status, first.repetition) == ("21" * 32, "planned", 1)


def test_finished_trial_is_stored_whole(
    driven: Path, samples: NDArray[np.float64], stream: Stream, events: tuple[Event, ...]
) -> None:
    assert rows(
        driven,
        "SELECT status, duration_s, path_length_m, collisions, collisions_legacy, contact_time_s "
        "FROM trial WHERE id = 1",
    ) == [("completed", 12.5, 4.25, 2, 5, 0.75)]
    assert rows(driven, "SELECT t, kind, detail FROM event WHERE trial_id = 1") == list(events)
    assert rows(driven, "SELECT count(*), count(omega) FROM sample WHERE trial_id = 2") == [
        (200, 0)
    ]
    assert rows(driven, "SELECT x, tau FROM sample WHERE trial_id = 1 AND t = 0.05") == [
        (samples[1, 1], samples[1, 12])
    ]
    assert rows(driven, "SELECT sum(rows) FROM chunk") == [(2 * len(stream.data),)]


def test_what_does_not_exist_is_null(study: Path, samples: NDArray[np.float64]) -> None:
    nothing = TrialOutcome(
        status="aborted",
        reason="never commanded",
        duration_s=float("nan"),
        path_length_m=0.0,
        collisions=0,
        collisions_legacy=0,
        contact_time_s=0.0,
    )
    with StudyWriter.open(study) as writer:
        writer.start_trial(1)
        writer.finish_trial(1, nothing, [], samples[:0], [])
    found = rows(study, "SELECT status, reason, duration_s FROM trial WHERE id = 1")
    assert found == [("aborted", "never commanded", None)]


def test_samples_of_another_shape_are_refused(
    study: Path, outcome: TrialOutcome, samples: NDArray[np.float64]
) -> None:
    with StudyWriter.open(study) as writer:
        writer.start_trial(1)
        with pytest.raises(ValueError, match=r"\(200, 12\)"):
            writer.finish_trial(1, outcome, [Event(0.0, "start")], samples[:, 1:], [])
    assert rows(study, "SELECT status FROM trial WHERE id = 1") == [("running",)]
    assert rows(study, "SELECT count(*) FROM event") == [(0,)]


def test_a_trial_is_run_once(study: Path, finish: FinishTrial, outcome: TrialOutcome) -> None:
    with StudyWriter.open(study) as writer:
        with pytest.raises(WrongTrialStatus, match="trial 1 is planned and cannot be finished"):
            writer.finish_trial(1, outcome, [], np.empty((0, 13)), [])
        finish(writer, 1)
        with pytest.raises(WrongTrialStatus, match="trial 1 is completed and cannot be started"):
            writer.start_trial(1)
        with pytest.raises(NoSuchTrial, match="no trial 99"):
            writer.start_trial(99)


def test_interrupted_trials_can_be_run_again(study: Path, finish: FinishTrial) -> None:
    with StudyWriter.open(study) as writer:
        writer.start_trial(2)
    with StudyWriter.open(study) as writer:
        assert [trial.id for trial in writer.interrupted_trials()] == [2]
        assert [trial.id for trial in writer.planned_trials("P01")] == [1, 3]
        writer.release_trial(2)
        assert writer.interrupted_trials() == ()
        assert [trial.id for trial in writer.planned_trials("P01")] == [1, 2, 3]
        finish(writer, 2)


def test_void_trials_are_repeated_in_their_place(study: Path, finish: FinishTrial) -> None:
    with StudyWriter.open(study) as writer:
        finish(writer, 2)
        with pytest.raises(WrongTrialStatus, match="void or aborted"):
            writer.add_attempt(2, "f" * 64, "again")
        writer.void_trial(2, "the display went dark")
        again = writer.add_attempt(2, "f" * 64, "repeats attempt 1")
        trials = writer.trials("P01")
    assert [(trial.id, trial.position, trial.attempt, trial.status) for trial in trials] == [
        (1, 1, 1, "planned"),
        (2, 2, 1, "void"),
        (again, 2, 2, "planned"),
        (3, 3, 1, "planned"),
    ]
    assert trials[1].reason == "the display went dark"
    assert trials[2].reason == "repeats attempt 1"
    assert trials[2].seed == "f" * 64
    assert (trials[2].condition, trials[2].repetition) == ("without", 2)
    assert rows(study, "SELECT count(*) FROM sample WHERE trial_id = 2") == [(200,)]


def test_sessions_and_participants_carry_their_status(study: Path) -> None:
    with StudyWriter.open(study) as writer:
        writer.set_participant_status(1, "active")
        writer.set_session_status(1, "running")
        assert rows(study, "SELECT finished_at FROM session WHERE id = 1") == [(None,)]
        writer.set_session_status(1, "aborted", "felt unwell")
    assert rows(study, "SELECT status FROM participant") == [("active",), ("enrolled",)]
    [(status, reason, started, finished)] = rows(
        study, "SELECT status, reason, started_at, finished_at FROM session WHERE id = 1"
    )
    assert (status, reason) == ("aborted", "felt unwell")
    assert str(started).endswith("Z")
    assert str(started) <= str(finished)


@pytest.mark.parametrize(
    "statement",
    [
        "UPDATE trial SET status = 'done'",
        "UPDATE participant SET kind = 'robot'",
        "UPDATE session SET status = 'done'",
        "UPDATE study SET kind = 'mixed'",
        "UPDATE trial SET seed = 'abc'",
        "UPDATE trial SET duration_s = -1",
        "UPDATE trial SET attempt = 0",
        "UPDATE trial SET position = 1",
        "UPDATE trial SET condition = 'nowhere'",
        "INSERT INTO event (trial_id, t, kind, detail) VALUES (99, 0, 'start', '')",
        "INSERT INTO condition VALUES ('third', 'A')",
    ],
)
def test_rows_that_make_no_sense_are_refused(study: Path, statement: str) -> None:
    with (
        StudyWriter.open(study) as writer,
        pytest.raises(IntegrityError),
        writer.transaction(),
    ):
        writer.connection.exec_driver_sql(statement)


def test_seeds_and_places_are_checked(study: Path) -> None:
    trial = NewTrial(session_id=1, position=1, kind="main", task="route", route="b", seed="1" * 64)
    with StudyWriter.open(study) as writer, pytest.raises(IntegrityError, match="UNIQUE"):
        writer.add_trial(trial)


def test_a_second_writer_is_sent_away(study: Path) -> None:
    with StudyWriter.open(study) as first:
        with pytest.raises(StudyBusy, match="another program"):
            StudyWriter.open(study)
        with pytest.raises(StudyBusy):
            upgrade_study(study)
        first.start_trial(1)
    with StudyWriter.open(study) as second:
        assert [trial.id for trial in second.interrupted_trials()] == [1]
    assert [entry.name for entry in study.parent.iterdir()] == ["small.db"]


def test_a_browser_that_holds_the_file_is_named(
    study: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("omnistudy.store.connection.BUSY_TIMEOUT_MS", 1)
    browser = sqlite3.connect(study)
    with StudyWriter.open(study) as writer:
        browser.execute("UPDATE study SET title = 'mine'")
        with pytest.raises(StudyBusy, match="another program"):
            writer.set_participant_status(2, "active")
        browser.rollback()
        writer.set_participant_status(2, "active")
    browser.close()


def test_same_results_give_the_same_samples(
    tmp_path: Path, make_study: Callable[[Path], Path], finish: FinishTrial
) -> None:
    one, two = make_study(tmp_path / "one.db"), make_study(tmp_path / "two.db")
    for path, order in ((one, (1, 2, 4)), (two, (4, 1, 2))):
        with StudyWriter.open(path) as writer:
            for trial in order:
                finish(writer, trial)
    assert rows(one, "SELECT * FROM sample") == rows(two, "SELECT * FROM sample")
    assert sample_digest(one) == sample_digest(two)
    ordered = np.array(rows(one, "SELECT * FROM sample ORDER BY trial_id, t"), dtype="<f8")
    assert sample_digest(one) == hashlib.sha256(ordered).hexdigest()
    with StudyWriter.open(two) as writer:
        finish(writer, 5)
    assert sample_digest(one) != sample_digest(two)
