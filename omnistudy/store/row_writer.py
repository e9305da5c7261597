"""Rows out of a ring into the study, a second of them a chunk, while a trial runs."""

from __future__ import annotations

import signal
import threading
import time
from multiprocessing.synchronize import Event
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import Connection, insert, select

from omnistudy.channel import Channel, Ring
from omnistudy.channel.orphan import orphaned
from omnistudy.channel.trial_row import TRIAL_ROW
from omnistudy.store.chunks import columns_text, pack, stored_numbers
from omnistudy.store.connection import in_plain_words, writing_engine
from omnistudy.store.rows import inserted_id
from omnistudy.store.tables import ChunkRow, StreamRow

LOOK_S = 0.05
"""s between two looks into the ring (ours)."""
IDLE_S = 0.25
"""s without a new row after which an unfinished second is written (ours)."""
TRIAL, ROW, FIRST_CHANNEL = 0, 1, len(TRIAL_ROW)


class StreamHead(NamedTuple):
    """What the rows of a ring become: the stream's name, rate and channels.

    channels : of a row without TRIAL_ROW; row i of the stream is row i of its trial.
    """

    name: str
    rate_hz: int
    channels: tuple[Channel, ...]


class RowWriter:
    """Writes into the study beside its StudyWriter, whose lock covers both.

    A row leaves the ring when it is safe in the study, so that a successor misses none.
    """

    def __init__(self, connection: Connection, study: Path, ring: Ring, head: StreamHead) -> None:
        self._connection = connection
        self._study = study
        self._ring = ring
        self._head = head
        self._trial = 0
        self._stream = 0
        self._next = 0

    def drain(self, *, whole: bool) -> None:
        """Write every full second that waits, and with `whole` what is left too."""
        first, rows = self._ring.read()
        ends = np.flatnonzero(np.diff(rows[:, TRIAL])) + 1
        for number, piece in enumerate(np.split(rows, ends) if len(rows) else ()):
            is_last = number == len(ends)
            while len(piece) >= self._head.rate_hz or (len(piece) and (whole or not is_last)):
                taken, piece = piece[: self._head.rate_hz], piece[self._head.rate_hz :]
                self._write(taken)
                first += len(taken)
                self._ring.take(first)

    def _write(self, rows: NDArray[np.float64]) -> None:
        """Write rows of one trial as one chunk, but for those that are there already."""
        head = self._head
        with in_plain_words(self._study), self._connection.begin():
            if int(rows[0, TRIAL]) != self._trial:
                self._go_on_with(int(rows[0, TRIAL]))
            new = rows[rows[:, ROW] >= self._next]
            if not len(new):
                return
            numbers = stored_numbers(new[:, FIRST_CHANNEL:], head.channels)
            chunk = pack(numbers, new[0, ROW] / head.rate_hz)
            self._connection.execute(
                insert(ChunkRow).values(stream_id=self._stream, **chunk._asdict())
            )
        self._next = int(new[-1, ROW]) + 1

    def _go_on_with(self, trial: int) -> None:
        """Find where the stream of a trial ends, or begin it."""
        head = self._head
        found = self._connection.scalar(
            select(StreamRow.id).where(StreamRow.trial_id == trial, StreamRow.name == head.name)
        )
        if found is None:
            begun = insert(StreamRow).values(
                trial_id=trial,
                name=head.name,
                rate_hz=head.rate_hz,
                columns=columns_text(head.channels),
            )
            found = inserted_id(self._connection.execute(begun))
        last = self._connection.execute(
            select(ChunkRow.t0, ChunkRow.rows)
            .where(ChunkRow.stream_id == found)
            .order_by(ChunkRow.t0.desc())
            .limit(1)
        ).first()
        self._trial, self._stream = trial, found
        self._next = 0 if last is None else round(last.t0 * head.rate_hz) + last.rows


def write_rows(study: Path, ring: Path, head: StreamHead, ready: Event) -> None:
    """Write rows until this process is told to end or its parent is gone, and all that waits then.

    ready : set once rows are looked for. Raises StoreFull, StudyBusy, NotWritable, DatabaseDamaged.
    """
    ending = threading.Event()
    signal.signal(signal.SIGTERM, lambda *_: ending.set())
    rows = Ring(ring)
    with in_plain_words(study), writing_engine(study).connect() as connection:
        writer = RowWriter(connection, study, rows, head)
        grown_at, written = time.monotonic(), rows.written
        ready.set()
        while True:
            told = ending.wait(LOOK_S)
            if rows.written != written:
                grown_at, written = time.monotonic(), rows.written
            idle = time.monotonic() - grown_at > IDLE_S
            writer.drain(whole=told or idle)
            if told or (idle and orphaned()):
                return
