"""Writing a study's design: its protocol, its slots, and who takes part."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Self

from sqlalchemy import Connection, insert, select, update

from omnistudy.store.connection import in_plain_words, writing_engine
from omnistudy.store.draft import draft_of
from omnistudy.store.file_check import check_file
from omnistudy.store.lock import sole_writer
from omnistudy.store.records import (
    NewAllocation,
    NewCondition,
    NewParticipant,
    NewStudy,
    ParticipantStatus,
    SessionStatus,
    StudyRecord,
)
from omnistudy.store.rows import (
    inserted_id,
    stored_study,
)
from omnistudy.store.schema import check_revision, migrate
from omnistudy.store.tables import (
    AllocationRow,
    Base,
    ConditionLevelRow,
    ConditionRow,
    ParticipantRow,
    ProtocolVersionRow,
    SessionRow,
    StudyRow,
    TrialRow,
)
from omnistudy.version import VERSION


class DesignWriter:
    """Opens a study database to write, and writes who takes part in what; see StudyWriter."""

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

    @property
    def study(self) -> StudyRecord:
        """Name, title, kind, hashes and protocol of the study."""
        with self.transaction():
            return stored_study(self.connection)

    def _add_study(self, study: NewStudy) -> None:
        values = asdict(study)
        values["protocol"] = values.pop("protocol_json")
        values |= {"created_at": now(), "omnistudy_version": VERSION}
        self.connection.execute(insert(StudyRow).values(values))
        self._add_version(study.protocol_version, "first freeze")

    def _add_version(self, version: int, reason: str) -> None:
        """Copy the study's protocol into the list of its versions."""
        row = self.connection.execute(select(StudyRow)).one()
        self.connection.execute(
            insert(ProtocolVersionRow).values(
                version=version,
                protocol=row.protocol,
                design_hash=row.design_hash,
                site_hash=row.site_hash,
                reason=reason,
                frozen_at=now(),
                omnistudy_version=VERSION,
            )
        )

    def amend(self, amended: NewStudy, conditions: Sequence[NewCondition], reason: str) -> None:
        """Put an amended protocol in the place of the present one, which stays in the list.

        What is still planned takes the new version; conditions keep names and levels.
        """
        values = {
            "title": amended.title,
            "protocol": amended.protocol_json,
            "protocol_version": amended.protocol_version,
            "design_hash": amended.design_hash,
            "site_hash": amended.site_hash,
        }
        with self.transaction():
            self.connection.execute(update(StudyRow).values(values))
            self._add_version(amended.protocol_version, reason)
            self._label([(one.name, f"{one.name} is labelled anew") for one in conditions])
            self._label([(one.name, one.masked_label) for one in conditions])
            self.connection.execute(
                update(TrialRow)
                .where(TrialRow.status == "planned")
                .values(protocol_version=amended.protocol_version)
            )

    def _label(self, labels: Iterable[tuple[str, str]]) -> None:
        """Set masked labels; two passes let conditions swap theirs, which are unique."""
        for name, label in labels:
            self.connection.execute(
                update(ConditionRow).where(ConditionRow.name == name).values(masked_label=label)
            )

    def add_allocations(self, allocations: Iterable[NewAllocation]) -> None:
        """Add the slots of the design, nobody in them."""
        with self.transaction():
            for slot, stratum, group, row in allocations:
                values = {"slot": slot, "stratum": stratum, "group_name": group, "row": row}
                self.connection.execute(insert(AllocationRow).values(values))

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

    def add_participant(self, participant: NewParticipant, slot: int) -> int:
        """Add somebody who takes part, in a slot of the design; gives the id."""
        with self.transaction():
            participant_id = self._insert(ParticipantRow, asdict(participant))
            self.connection.execute(
                update(AllocationRow)
                .where(AllocationRow.slot == slot)
                .values(participant_id=participant_id)
            )
        return participant_id

    def add_session(self, participant_id: int, visit: int = 1) -> int:
        """Add a planned visit of a participant; gives the id."""
        return self._insert(
            SessionRow,
            {"participant_id": participant_id, "visit": visit, "status": "planned", "reason": ""},
        )

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
            values[stamps[status]] = now()
        with self.transaction():
            self.connection.execute(
                update(SessionRow).where(SessionRow.id == session_id).values(values)
            )

    def _insert(self, table: type[Base], values: dict[str, Any]) -> int:
        with self.transaction():
            return inserted_id(self.connection.execute(insert(table).values(values)))


def now() -> datetime:
    """Give this moment in UTC."""
    return datetime.now(UTC)
