"""Writing a study: its making, its trials as they are run. One process writes at a time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import select, update

from omnistudy.channel import Event, Measure, Stream
from omnistudy.devices import DeviceRecord
from omnistudy.errors.store import NoSuchTrial, WrongTrialStatus
from omnistudy.store.design_writer import DesignWriter, now
from omnistudy.store.records import (
    NewTrial,
    StoredTrial,
    TrialOutcome,
    TrialStatus,
)
from omnistudy.store.rows import (
    insert_device,
    insert_events,
    insert_measures,
    insert_samples,
    insert_streams,
    stored_trials,
)
from omnistudy.store.tables import StreamRow, TrialRow


class StudyWriter(DesignWriter):
    """A study database opened to write, by one process at a time; use as a context manager.

    Every method is a transaction of its own unless it stands inside `with writer.transaction():`.
    All raise StoreFull, StudyBusy, NotWritable or DatabaseDamaged when the disk says so, and then
    nothing of the transaction is kept.
    """

    def add_trial(self, trial: NewTrial) -> int:
        """Add a planned trial; gives the id."""
        return self._insert(TrialRow, asdict(trial) | {"status": "planned"})

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
            self._update_trial(trial_id, {"status": "running", "started_at": now()})

    def choose_condition(self, trial_id: int, condition: str, repetition: int) -> None:
        """Note what an order that adapts chose for a planned trial; raises WrongTrialStatus."""
        with self.transaction():
            self._require(trial_id, "given a condition", "planned")
            self._update_trial(trial_id, {"condition": condition, "repetition": repetition})

    def has_streams(self, trial_id: int) -> bool:
        """Tell whether something of a trial was recorded while it ran."""
        with self.transaction():
            query = select(StreamRow.id).where(StreamRow.trial_id == trial_id).limit(1)
            return self.connection.scalar(query) is not None

    def release_trial(self, trial_id: int) -> None:
        """Make a running trial planned again, after a crash that left nothing of it."""
        with self.transaction():
            self._require(trial_id, "released", "running")
            self._update_trial(trial_id, {"status": "planned", "started_at": None})

    def void_trial(self, trial_id: int, reason: str) -> None:
        """Give up a trial that has no result, and say why; what there is of it is kept."""
        with self.transaction():
            self._require(trial_id, "voided", "planned", "running", "completed", "timed_out")
            self._update_trial(trial_id, {"status": "void", "reason": reason, "finished_at": now()})

    def finish_trial(
        self,
        trial_id: int,
        outcome: TrialOutcome,
        events: Sequence[Event],
        samples: NDArray[np.float64],
        streams: Sequence[Stream],
        device: DeviceRecord | None = None,
        measures: Sequence[Measure] = (),
    ) -> None:
        """Write all that a running trial left behind, in one transaction.

        samples : (n, 13) float64, columns SAMPLE_COLUMNS.
        device : what it was driven with. measures : how well it was run.
        Raises WrongTrialStatus unless the trial is running; StoreFull, and then the trial stays
        running without any row.
        """
        with self.transaction():
            self._require(trial_id, "finished", "running")
            insert_events(self.connection, trial_id, events)
            insert_samples(self.connection, trial_id, samples)
            insert_streams(self.connection, trial_id, streams)
            insert_device(self.connection, trial_id, device)
            insert_measures(self.connection, trial_id, measures)
            self._update_trial(trial_id, asdict(outcome) | {"finished_at": now()})

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
