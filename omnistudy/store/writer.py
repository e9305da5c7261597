"""Writing a study: its making, its trials as they are run. One process writes at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, fields
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import Connection, insert, select, update

from omnistudy.channel import Event, Stream
from omnistudy.errors.store import NoSuchTrial, WrongTrialStatus
from omnistudy.store.connection import in_plain_words, writing_engine
from omnistudy.store.draft import draft_of
from omnistudy.store.file_check import check_file
from omnistudy.store.lock import sole_writer
from omnistudy.store.records import (
    NewCondition,
    NewParticipant,
    NewStudy,
    NewTrial,
    ParticipantStatus,
    SessionStatus,
    StoredTrial,
    StudyRecord,
    TrialOutcome,
    TrialStatus,
)
from omnistudy.store.rows import (
    insert_events,
    insert_samples,
    insert_streams,
    inserted_id,
    stored_study,
    stored_trials,
)
from omnistudy.store.schema import check_revision, migrate
from omnistudy.store.tables import (
    Base,
    ConditionLevelRow,
    ConditionRow,
    ParticipantRow,
    SessionRow,
    StudyRow,
    TrialRow,
)
from omnistudy.version import VERSION


class StudyWriter:
    """A study database opened to write, by one process at a time; use as a context manager.

    Every method is a transaction of its own unless it stands inside `with writer.transaction():`.
    All raise StoreFull, StudyBusy, NotWritable or DatabaseDamaged when the disk says so, and then
    nothing of the transaction is kept.
    """

    def __init__(self, path: Path, draft: Path | None = None) -> None:
        self.path = path
        with ExitStack() as held:
            file = draft or path
            held.enter_context(sole_writer(file))
            with in_plain_words(path):
                self.connection: Connection = held.enter_context(writing_engine(file).connect())
            self._held = held.pop_all()

    @classmethod
    def open(cls, path: str | Path) -> Self:
        """Open a study that exists; raises as `omnistudy.open` does, and StudyBusy."""
        path = Path(path)
        check_file(path)
        writer = cls(path)
        try:
            with writer.transaction():
                check_revision(writer.connection, path)
        except BaseException:
            writer.close()
            raise
        return writer

    @classmethod
    @contextmanager
    def create(cls, path: str | Path, study: NewStudy) -> Iterator[Self]:
        """Make a new study; all that happens inside the block is kept, or no file at all.

        Raises StudyExists for a path that is taken.
        """
        path = Path(path)
        with (
            draft_of(path) as draft,
            cls(path, draft) as writer,
            writer.transaction(),
        ):
            migrate(writer.connection)
            writer._add_study(study)
            yield writer

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Let go of the file."""
        self._held.close()

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """Keep all that is written inside the block, or nothing of it; inner blocks join."""
        if self.connection.in_transaction():
            yield
            return
        with in_plain_words(self.path), self.connection.begin():
            yield

    def _add_study(self, study: NewStudy) -> None:
        values = asdict(study)
        values["protocol"] = values.pop("protocol_json")
        values |= {"created_at": _now(), "omnistudy_version": VERSION}
        self.connection.execute(insert(StudyRow).values(values))

    def add_conditions(self, conditions: Iterable[NewCondition]) -> None:
        """Add the conditions of the design with their levels."""
        with self.transaction():
            for condition in conditions:
                self.connection.execute(
                    insert(ConditionRow).values(
                        name=condition.name, masked_label=condition.masked_label
                    )
                )
                for level in condition.levels:
                    self.connection.execute(
                        insert(ConditionLevelRow).values(
                            condition=condition.name, factor=level.factor, level=level.level
                        )
                    )

    def add_participant(self, participant: NewParticipant) -> int:
        """Add somebody who takes part; gives the id."""
        return self._insert(ParticipantRow, asdict(participant))

    def add_session(self, participant_id: int, visit: int = 1) -> int:
        """Add a planned visit of a participant; gives the id."""
        return self._insert(
            SessionRow,
            {"participant_id": participant_id, "visit": visit, "status": "planned", "reason": ""},
        )

    def add_trial(self, trial: NewTrial) -> int:
        """Add a planned trial; gives the id."""
        return self._insert(TrialRow, asdict(trial) | {"status": "planned"})

    def set_participant_status(self, participant_id: int, status: ParticipantStatus) -> None:
        """Note how far a participant is."""
        with self.transaction():
            self.connection.execute(
                update(ParticipantRow)
                .where(ParticipantRow.id == participant_id)
                .values(status=status)
            )

    def set_session_status(self, session_id: int, status: SessionStatus, reason: str = "") -> None:
        """Note how far a session is; "running" and what ends it stamp the wall clock."""
        stamps: dict[SessionStatus, str] = {
            "running": "started_at",
            "completed": "finished_at",
            "aborted": "finished_at",
        }
        values: dict[str, Any] = {"status": status, "reason": reason}
        if status in stamps:
            values[stamps[status]] = _now()
        with self.transaction():
            self.connection.execute(
                update(SessionRow).where(SessionRow.id == session_id).values(values)
            )

    @property
    def study(self) -> StudyRecord:
        """Name, title, kind, hashes and protocol of the study."""
        with self.transaction():
            return stored_study(self.connection)

    def trials(self, participant: str | None = None) -> tuple[StoredTrial, ...]:
        """Give every attempt at every trial, of one participant (by code) or of all, in order."""
        with self.transaction():
            return stored_trials(self.connection, participant=participant)

    def planned_trials(self, participant: str | None = None) -> tuple[StoredTrial, ...]:
        """Give the trials still to be run, of one participant (by code) or of all, in order."""
        with self.transaction():
            return stored_trials(self.connection, status="planned", participant=participant)

    def interrupted_trials(self, participant: str | None = None) -> tuple[StoredTrial, ...]:
        """Give the trials that are running; after a crash nobody runs them any more."""
        with self.transaction():
            return stored_trials(self.connection, status="running", participant=participant)

    def start_trial(self, trial_id: int) -> None:
        """Mark a planned trial as running; raises WrongTrialStatus for any other."""
        with self.transaction():
            self._require(trial_id, "started", "planned")
            self._update_trial(trial_id, {"status": "running", "started_at": _now()})

    def release_trial(self, trial_id: int) -> None:
        """Make a running trial planned again, after a crash that left nothing of it."""
        with self.transaction():
            self._require(trial_id, "released", "running")
            self._update_trial(trial_id, {"status": "planned", "started_at": None})

    def void_trial(self, trial_id: int, reason: str) -> None:
        """Give up a trial that has no result, and say why; what there is of it is kept."""
        with self.transaction():
            self._require(trial_id, "voided", "planned", "running", "completed", "timed_out")
            self._update_trial(
                trial_id, {"status": "void", "reason": reason, "finished_at": _now()}
            )

    def finish_trial(
        self,
        trial_id: int,
        outcome: TrialOutcome,
        events: Sequence[Event],
        samples: NDArray[np.float64],
        streams: Sequence[Stream],
    ) -> None:
        """Write all that a running trial left behind, in one transaction.

        samples : (n, 13) float64, columns SAMPLE_COLUMNS.
        Raises WrongTrialStatus unless the trial is running; StoreFull, and then the trial stays
        running without any row.
        """
        with self.transaction():
            self._require(trial_id, "finished", "running")
            insert_events(self.connection, trial_id, events)
            insert_samples(self.connection, trial_id, samples)
            insert_streams(self.connection, trial_id, streams)
            self._update_trial(trial_id, asdict(outcome) | {"finished_at": _now()})

    def add_attempt(self, trial_id: int, seed: str, reason: str) -> int:
        """Plan the next attempt at a void or aborted trial, in its place; gives the new id.

        seed : of the new attempt; `reason` says why it is repeated.
        """
        with self.transaction():
            self._require(trial_id, "repeated", "void", "aborted")
            (trial,) = stored_trials(self.connection, trial_id=trial_id)
            kept = {field.name: getattr(trial, field.name) for field in fields(NewTrial)}
            changed = {"seed": seed, "reason": reason, "attempt": trial.attempt + 1}
            return self.add_trial(NewTrial(**kept | changed))

    def _require(self, trial_id: int, action: str, *needed: TrialStatus) -> None:
        status = self.connection.scalar(select(TrialRow.status).where(TrialRow.id == trial_id))
        if status is None:
            raise NoSuchTrial(self.path, trial_id)
        if status not in needed:
            raise WrongTrialStatus(trial_id, status, action, needed)

    def _update_trial(self, trial_id: int, values: dict[str, Any]) -> None:
        self.connection.execute(update(TrialRow).where(TrialRow.id == trial_id).values(values))

    def _insert(self, table: type[Base], values: dict[str, Any]) -> int:
        with self.transaction():
            return inserted_id(self.connection.execute(insert(table).values(values)))


def _now() -> datetime:
    return datetime.now(UTC)
