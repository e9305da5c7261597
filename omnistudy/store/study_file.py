"""Reading a study: `omnistudy.open(PATH)`."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Self

import numpy as np
from sqlalchemy import Connection, func, select

from omnistudy.channel import SAMPLE_CHANNELS, SAMPLE_COLUMNS, Stream
from omnistudy.errors.store import DatabaseDamaged, NoSuchStream, NoSuchTrial
from omnistudy.store import frames
from omnistudy.store.chunks import Chunk, channels_from, real_values, unpack
from omnistudy.store.connection import in_plain_words, reading_engine, remove_empty_log
from omnistudy.store.file_check import check_file
from omnistudy.store.records import ProtocolVersion, StudyRecord
from omnistudy.store.rows import stored_limits, stored_study, stored_versions
from omnistudy.store.schema import check_revision
from omnistudy.store.tables import (
    ChunkRow,
    ParticipantRow,
    SampleRow,
    StreamRow,
    TrialRow,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from pandas import DataFrame


def open_study(path: str | Path) -> StudyFile:
    """Open a study to read.

    Raises StudyNotFound, NotAStudy, DatabaseTooOld, DatabaseTooNew or DatabaseDamaged.
    """
    path = Path(path)
    check_file(path)
    with in_plain_words(path):
        connection = reading_engine(path).connect()
        try:
            with connection.begin():
                check_revision(connection, path)
        except BaseException:
            connection.close()
            raise
    return StudyFile(path, connection)


class StudyFile:
    """A study opened to read; nothing of it can be changed through this.

    Frames are tidy, one thing a row; `frame.attrs["units"]` maps columns to units. Trials are
    called by their number, the column `trial` of `trials()`.
    """

    def __init__(self, path: Path, connection: Connection) -> None:
        self.path = path
        self.connection = connection
        with self.reading():
            self.study: StudyRecord = stored_study(connection)
            """Name, title, kind, hashes and protocol."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Let go of the file."""
        self.connection.close()
        remove_empty_log(self.path)

    def __repr__(self) -> str:
        with self.reading() as connection:
            participants = connection.scalar(select(func.count()).select_from(ParticipantRow))
            trials = connection.scalar(
                select(func.count()).select_from(TrialRow).where(TrialRow.status != "void")
            )
            done = connection.scalar(
                select(func.count()).select_from(TrialRow).where(TrialRow.status == "completed")
            )
        return (
            f"<{self.study.kind} study '{self.study.name}': {participants} participants, "
            f"{done} of {trials} trials completed, in {self.path}>"
        )

    @contextmanager
    def reading(self) -> Iterator[Connection]:
        """Give the connection; all that is read inside the block is of the same instant."""
        if self.connection.in_transaction():
            yield self.connection
            return
        with in_plain_words(self.path), self.connection.begin():
            yield self.connection

    def trials(self) -> DataFrame:
        """Give one row an attempt at a trial, planned ones too, with a column a factor."""
        with self.reading() as connection:
            return frames.trials_frame(connection)

    def participants(self) -> DataFrame:
        """Give one row a participant."""
        with self.reading() as connection:
            return frames.participants_frame(connection)

    def sessions(self) -> DataFrame:
        """Give one row a visit."""
        with self.reading() as connection:
            return frames.sessions_frame(connection)

    def conditions(self) -> DataFrame:
        """Give one row a condition, with a column a factor."""
        with self.reading() as connection:
            return frames.conditions_frame(connection)

    def allocations(self) -> DataFrame:
        """Give one row a slot of the design, drawn at the first freeze, with who sits in it."""
        with self.reading() as connection:
            return frames.allocations_frame(connection)

    def protocol_versions(self) -> tuple[ProtocolVersion, ...]:
        """Give every version of the protocol, the first one first."""
        with self.reading() as connection:
            return stored_versions(connection)

    def events(self, trial: int | None = None) -> DataFrame:
        """Give one row an event, of one trial (raises NoSuchTrial) or of all."""
        with self.reading() as connection:
            if trial is not None:
                trial = self._trial_id(trial)
            return frames.events_frame(connection, trial)

    def devices(self) -> DataFrame:
        """Give one row an attempt that was driven: with which device, and what its force is."""
        with self.reading() as connection:
            return frames.devices_frame(connection)

    def measures(self, trial: int | None = None) -> DataFrame:
        """Give one row a number about how well one trial (raises NoSuchTrial) or all were run."""
        with self.reading() as connection:
            if trial is not None:
                trial = self._trial_id(trial)
            return frames.measures_frame(connection, trial)

    def exclusions(self) -> DataFrame:
        """Give one row a limit of the protocol that an attempt is above, which is not analysed.

        Columns trial, measure, value, greatest, unit.
        """
        with self.reading() as connection:
            return frames.exclusions_frame(connection, stored_limits(self.study))

    def samples(self, trial: int) -> DataFrame:
        """Give one row a sample of a trial, columns SAMPLE_COLUMNS; raises NoSuchTrial."""
        samples = self.sample_array(trial)
        return frames.channel_frame(samples[:, 0], SAMPLE_CHANNELS, samples[:, 1:])

    def sample_array(self, trial: int) -> NDArray[np.float64]:
        """Give (n, 13) float64, columns SAMPLE_COLUMNS, NaN for NULL; raises NoSuchTrial."""
        table = SampleRow.__table__
        columns = [table.c[name] for name in SAMPLE_COLUMNS]
        with self.reading() as connection:
            trial = self._trial_id(trial)
            rows = connection.execute(
                select(*columns).where(table.c.trial_id == trial).order_by(table.c.t)
            ).all()
        return np.array([tuple(row) for row in rows], dtype=np.float64).reshape(
            -1, len(SAMPLE_COLUMNS)
        )

    def streams(self, trial: int) -> DataFrame:
        """Give one row a stream of a trial: name, rate, rows, columns; raises NoSuchTrial."""
        with self.reading() as connection:
            trial = self._trial_id(trial)
            found = connection.execute(
                select(
                    StreamRow.name,
                    StreamRow.rate_hz,
                    func.coalesce(func.sum(ChunkRow.rows), 0).label("rows"),
                    StreamRow.columns,
                )
                .outerjoin(ChunkRow, ChunkRow.stream_id == StreamRow.id)
                .where(StreamRow.trial_id == trial)
                .group_by(StreamRow.id)
                .order_by(StreamRow.id)
            ).all()
        return frames.frame(
            ("name", "rate_hz", "rows", "columns"),
            [
                (name, rate, rows, tuple(channel.name for channel in channels_from(text)))
                for name, rate, rows, text in found
            ],
        )

    def stream(self, trial: int, name: str) -> DataFrame:
        """Give one row a tick of a stream: t in s, then its channels.

        Raises NoSuchTrial, NoSuchStream, DatabaseDamaged.
        """
        stream = self.stream_record(trial, name)
        times = np.arange(len(stream.data)) / stream.rate_hz
        return frames.channel_frame(times, stream.channels, stream.data)

    def stream_record(self, trial: int, name: str) -> Stream:
        """Give a stream as it was recorded, to simulate the trial again; raises as `stream`."""
        with self.reading() as connection:
            trial = self._trial_id(trial)
            found = connection.execute(
                select(StreamRow).where(StreamRow.trial_id == trial).order_by(StreamRow.id)
            ).all()
            row = next((row for row in found if row.name == name), None)
            if row is None:
                raise NoSuchStream(trial, name, [row.name for row in found])
            packed = connection.execute(
                select(ChunkRow.t0, ChunkRow.rows, ChunkRow.sha256, ChunkRow.data)
                .where(ChunkRow.stream_id == row.id)
                .order_by(ChunkRow.t0)
            ).all()
        channels = channels_from(row.columns)
        try:
            pieces = [unpack(Chunk(*chunk), len(channels)) for chunk in packed]
        except ValueError as error:
            raise DatabaseDamaged(self.path, f"trial {trial}, stream '{name}': {error}") from error
        data = np.concatenate([np.empty((0, len(channels))), *pieces])
        return Stream(name, row.rate_hz, channels, real_values(data, channels))

    def _trial_id(self, trial: int) -> int:
        """Give the number of a trial as SQLite knows it, numpy's from a frame's column too."""
        found = self.connection.scalar(select(TrialRow.id).where(TrialRow.id == int(trial)))
        if found is None:
            raise NoSuchTrial(self.path, trial)
        return found
