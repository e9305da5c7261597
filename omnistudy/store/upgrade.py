"""Bringing an older study database to the newest revision, after copying it."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

from omnistudy.errors.store import DatabaseDamaged, DatabaseTooNew
from omnistudy.store.connection import in_plain_words, reading_engine, writing_engine
from omnistudy.store.draft import draft_of
from omnistudy.store.file_check import check_file
from omnistudy.store.lock import sole_writer
from omnistudy.store.schema import is_known, migrate, newest_revision, revision_of


def upgrade_study(path: str | Path) -> Path | None:
    """Copy a database beside itself, then migrate it; gives the copy, None when it is current.

    Raises StudyNotFound, NotAStudy, DatabaseTooNew, DatabaseDamaged, StudyBusy, StoreFull; the
    database is then as it was.
    """
    path = Path(path)
    check_file(path)
    with sole_writer(path):
        return _upgrade(path)


def _upgrade(path: Path) -> Path | None:
    with in_plain_words(path), reading_engine(path).begin() as connection:
        revision = revision_of(connection, path)
    newest = newest_revision()
    if revision == newest:
        return None
    if not is_known(revision):
        raise DatabaseTooNew(path, revision, newest)
    copy = _free_name(path, revision)
    copy_study(path, copy)
    with in_plain_words(path), writing_engine(path, foreign_keys=False).begin() as connection:
        migrate(connection)
        if connection.exec_driver_sql("PRAGMA foreign_key_check").first() is not None:
            raise DatabaseDamaged(path, "rows point at rows that are not there")
    return copy


def copy_study(path: Path, copy: Path) -> None:
    """Copy a database whole, even while it is written to; raises StudyExists, StoreFull."""
    with (
        draft_of(copy) as draft,
        in_plain_words(copy),
        closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)) as source,
        closing(sqlite3.connect(draft)) as target,
    ):
        source.backup(target)


def _free_name(path: Path, revision: str) -> Path:
    copy = path.with_name(f"{path.stem}.revision-{revision}{path.suffix}")
    number = 1
    while copy.exists():
        number += 1
        copy = path.with_name(f"{path.stem}.revision-{revision}-{number}{path.suffix}")
    return copy
