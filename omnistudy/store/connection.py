"""Connections to SQLite, and what SQLite's complaints mean to a user."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from sqlalchemy import Connection, Engine, NullPool, create_engine, event
from sqlalchemy.exc import DBAPIError

from omnistudy.errors import OmnistudyError
from omnistudy.errors.store import DatabaseDamaged, DiskFailed, NotWritable, StoreFull, StudyBusy

BUSY_TIMEOUT_MS = 10_000
"""How long to wait for another writer before giving up."""


def writing_engine(path: Path, *, foreign_keys: bool = True) -> Engine:
    """Give an engine that may write: WAL, every commit flushed, foreign keys on.

    `foreign_keys=False` is for migrations, which replace whole tables.
    """

    def connect() -> sqlite3.Connection:
        return _prepared(
            sqlite3.connect(f"{path.absolute().as_uri()}?mode=rw", uri=True),
            "PRAGMA journal_mode = WAL",
            "PRAGMA synchronous = FULL",
            f"PRAGMA foreign_keys = {'ON' if foreign_keys else 'OFF'}",
        )

    return _engine(connect, begin="BEGIN IMMEDIATE")


def reading_engine(path: Path) -> Engine:
    """Give an engine that cannot write."""

    def connect() -> sqlite3.Connection:
        address = path.absolute().as_uri()
        first_look = ("PRAGMA query_only = ON", "SELECT 1 FROM sqlite_master")
        try:
            return _prepared(sqlite3.connect(f"{address}?mode=ro", uri=True), *first_look)
        except sqlite3.OperationalError as error:
            # WAL needs a helper file beside the database. In a folder that cannot be written there
            # is none, and nobody who could change the file under us either.
            if error.sqlite_errorcode & 0xFF not in (
                sqlite3.SQLITE_CANTOPEN,
                sqlite3.SQLITE_READONLY,
            ):
                raise
            return _prepared(sqlite3.connect(f"{address}?immutable=1", uri=True), *first_look)

    return _engine(connect, begin="BEGIN")


def remove_empty_log(path: Path) -> None:
    """Let SQLite take away the helper files that a reader leaves beside a WAL database.

    SQLite does so itself when the last connection that may write closes.
    """
    log = path.with_name(path.name + "-wal")
    if log.exists() and log.stat().st_size == 0 and os.access(path, os.W_OK):
        with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=rw", uri=True)) as database:
            database.execute("SELECT 1 FROM sqlite_master").fetchone()


def _prepared(database: sqlite3.Connection, *statements: str) -> sqlite3.Connection:
    """Run the statements that every connection of its kind begins with, or close it."""
    try:
        for statement in (f"PRAGMA busy_timeout = {BUSY_TIMEOUT_MS}", *statements):
            database.execute(statement).fetchall()
    except BaseException:
        database.close()
        raise
    return database


def _engine(connect: Callable[[], sqlite3.Connection], begin: str) -> Engine:
    engine = create_engine("sqlite://", creator=connect, poolclass=NullPool)

    # Left alone, Python's sqlite3 begins late, and not around reading or changes of tables.
    @event.listens_for(engine, "begin")
    def say_begin(connection: Connection) -> None:
        connection.exec_driver_sql(begin)

    return engine


@contextmanager
def in_plain_words(path: Path) -> Iterator[None]:
    """Turn SQLite's complaints about a file into StoreFull, StudyBusy, DatabaseDamaged, ..."""
    try:
        yield
    except (DBAPIError, sqlite3.Error) as error:
        meaning = _meaning(path, error.orig if isinstance(error, DBAPIError) else error)
        if meaning is None:
            raise
        raise meaning from error


def _meaning(path: Path, error: BaseException | None) -> OmnistudyError | None:
    code = getattr(error, "sqlite_errorcode", None)
    if code is None:
        return None
    match code & 0xFF:
        case sqlite3.SQLITE_FULL:
            return StoreFull(path)
        case sqlite3.SQLITE_BUSY | sqlite3.SQLITE_LOCKED:
            return StudyBusy(path)
        case sqlite3.SQLITE_CORRUPT | sqlite3.SQLITE_NOTADB:
            return DatabaseDamaged(path, str(error))
        case sqlite3.SQLITE_IOERR:
            return DiskFailed(path, str(error))
        case sqlite3.SQLITE_READONLY | sqlite3.SQLITE_CANTOPEN | sqlite3.SQLITE_PERM:
            return NotWritable(path)
        case _:
            return None
