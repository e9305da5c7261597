"""One writer at a time, for as long as it has the study open."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from omnistudy.errors.store import StudyBusy
from omnistudy.store.connection import in_plain_words


@contextmanager
def sole_writer(path: Path) -> Iterator[None]:
    """Keep other writers away from a study meanwhile; readers are free.

    The lock is SQLite's own on an empty file beside the study: it works on every system and ends
    with the process, however that ends. Raises StudyBusy at once, or NotWritable.
    """
    lock = path.with_name(path.name + "-lock")
    with in_plain_words(path), closing(sqlite3.connect(lock, timeout=0)) as held:
        held.execute("BEGIN EXCLUSIVE")
        if not lock.exists():  # its last holder was about to take it away
            raise StudyBusy(path)
        try:
            yield
        finally:
            if os.name == "posix":  # elsewhere an open file cannot be taken away, and stays
                lock.unlink(missing_ok=True)
