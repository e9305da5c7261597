"""A file that appears whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from omnistudy.errors.store import NotWritable, StudyExists


@contextmanager
def draft_of(path: Path) -> Iterator[Path]:
    """Give an empty file beside `path` that takes its place when the block ends well.

    When the block fails, nothing is left. Raises StudyExists or NotWritable.
    """
    _refuse_taken(path)
    draft = path.with_name(f".{path.name}.{os.getpid()}.new")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        draft.touch(exist_ok=False)
    except OSError as error:
        raise NotWritable(path) from error
    try:
        yield draft
        _refuse_taken(path)
        draft.rename(path)
    finally:
        for ending in ("", "-wal", "-shm"):
            draft.with_name(draft.name + ending).unlink(missing_ok=True)


def _refuse_taken(path: Path) -> None:
    if path.exists():
        raise StudyExists(path)
