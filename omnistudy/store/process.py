"""Recording in a process of its own: started, watched, and followed by another when it dies."""

from __future__ import annotations

import time
from multiprocessing import get_context
from multiprocessing.context import SpawnProcess
from pathlib import Path
from threading import Thread
from typing import Self

from sqlalchemy import func, select

from omnistudy.channel import Ring
from omnistudy.channel.child import start_child
from omnistudy.errors.store import RecorderFailed
from omnistudy.store.connection import in_plain_words, reading_engine
from omnistudy.store.row_writer import StreamHead, write_rows
from omnistudy.store.tables import ChunkRow, StreamRow

PATIENCE_S = 10.0
"""How long what waits in the ring may take into the study at a trial's end (ours)."""
STARTING_S = 60.0
"""How long the first process may take to start on a busy machine (ours)."""
MOST_DEATHS = 5
"""Recorders that may die before no other is started: the disk may be full (ours)."""


class Recorder:
    """Lets a process of its own write what comes through a ring into a study.

    deaths : recorders that ended unasked; each is followed by another, which goes on where the
        last one was. Nobody who fills the ring ever waits or hears of it.
    """

    def __init__(self, study: Path, ring: Path, head: StreamHead) -> None:
        """Start the process and wait until it looks into the ring.

        The study must be open to write in this process. Raises RecorderFailed.
        """
        self._study = study
        self._ready = get_context("spawn").Event()
        self._arguments = (study, ring, head, self._ready)
        self._head = head
        self._ring = Ring(ring)
        self._closing = False
        self.deaths = 0
        self._process = self._started()
        self._watch = Thread(target=self._follow, daemon=True)
        self._watch.start()
        if not self._ready.wait(STARTING_S):
            self.close()
            raise RecorderFailed(study)

    @property
    def process_id(self) -> int:
        """The process that writes at present."""
        assert self._process.pid is not None
        return self._process.pid

    def settle(self) -> bool:
        """Wait until all that is in the ring is in the study; False when that takes too long."""
        until = time.monotonic() + PATIENCE_S
        while self._ring.taken < self._ring.written:
            if time.monotonic() > until or self.deaths > MOST_DEATHS:
                return False
            time.sleep(0.01)
        return True

    def rows(self, trial: int) -> int:
        """Count the rows of a trial that are in the study."""
        query = (
            select(func.coalesce(func.sum(ChunkRow.rows), 0))
            .join(StreamRow, StreamRow.id == ChunkRow.stream_id)
            .where(StreamRow.trial_id == trial, StreamRow.name == self._head.name)
        )
        with in_plain_words(self._study), reading_engine(self._study).begin() as connection:
            return int(connection.scalar(query) or 0)

    def close(self) -> None:
        """End the process after it has written all that waits."""
        self.settle()
        self._closing = True
        self._process.terminate()
        self._watch.join(PATIENCE_S)
        if self._process.is_alive():
            self._process.kill()
        self._ring.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _started(self) -> SpawnProcess:
        process = get_context("spawn").Process(target=write_rows, args=self._arguments, daemon=True)
        start_child(process)
        return process

    def _follow(self) -> None:
        """Start another process whenever one dies."""
        while True:
            self._process.join()
            if self._closing:
                return
            self.deaths += 1
            if self.deaths > MOST_DEATHS:
                return
            self._process = self._started()
            if self._closing:
                self._process.terminate()
