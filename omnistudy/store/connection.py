"""Connections to SQLite, and what SQLite's complaints mean to a user."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from sqlalchemy import Connection, Engine, NullPool, create_engine, event
from sqlalchemy.exc import DBAPIError

from omnistudy.errors import OmnistudyError
from omnistudy.errors.store import DatabaseDamaged, NotWritable, StoreFull, StudyBusy

BUSY_TIMEOUT_MS = 10_000
"""How long to wait for another writer before giving up."""


def writing_engine(path: Path, *, foreign_keys: bool = True) -> Engine:
    """Give an engine that may write: WAL, every commit flushed, foreign keys on.

    `foreign_keys=False` is for migrations, which replace whole tables.
    """

    def connect() -> sqlite3.Connection:
        database = sqlite3.connect(f"{path.absolute().as_uri()}?mode=rw", uri=True)
        database.execute(f"PRAGMA busy_timeout = {BUSY_TIMEOUT_MS}")
        database.execute("PRAGMA journal_mode = WAL")
        database.execute("PRAGMA synchronous = FULL")
        database.execute(f"PRAGMA foreign_keys = {'ON' if foreign_keys else 'OFF'}")
        return database

    return _engine(connect, begin="BEGIN IMMEDIATE")


def reading_engine(path: Path) -> Engine:
    """Give an engine that cannot write."""

    def connect() -> sqlite3.Connection:
        address = path.absolute().as_uri()
        database = sqlite3.connect(f"{address}?mode=ro", uri=True)
        try:
            database.execute("SELECT 1 FROM sqlite_master").fetchone()
        except sqlite3.OperationalError as cause:
            # WAL needs a helper file beside the database. In a folder that cannot be written there
            # is none, and nobody who could change the file under us either.
            if cause.sqlite_errorcode & 0xFF not in (
                sqlite3.SQLITE_CANTOPEN,
                sqlite3.SQLITE_READONLY,
            ):
                raise
            database.close()
            database = sqlite3.connect(f"{address}?immutable=1", uri=True)
        database.execute("PRAGMA query_only = ON")
        database.execute(f"PRAGMA busy_timeout = {BUSY_TIMEOUT_MS}")
        return database

    return _engine(connect, begin="BEGIN")


def _engine(connect: Callable[[], sqlite3.Connection], begin: str) -> Engine:
    engine = create_engine("sqlite://", creator=connect, poolclass=NullPool)

    # Python's sqlite3 opens transactions late and not around changes of tables; we say BEGIN.
    @event.listens_for(engine, "connect")
    def no_hidden_transactions(database: sqlite3.Connection, _record: object) -> None:
        database.isolation_level = None

    @event.listens_for(engine, "begin")
    def say_begin(connection: Connection) -> None:
        connection.exec_driver_sql(begin)

    return engine


@contextmanager
def in_plain_words(path: Path) -> Iterator[None]:
    """Turn SQLite's complaints about a file into StoreFull, StudyBusy, DatabaseDamaged, ..."""
    try:
        yield
    except DBAPIError as error:
        meaning = _meaning(path, error.orig)
        if meaning is None:
            raise
        raise meaning from error
    except sqlite3.Error as error:
        meaning = _meaning(path, error)
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
        case sqlite3.SQLITE_CORRUPT | sqlite3.SQLITE_NOTADB | sqlite3.SQLITE_IOERR:
            return DatabaseDamaged(path, str(error))
        case sqlite3.SQLITE_READONLY | sqlite3.SQLITE_CANTOPEN | sqlite3.SQLITE_PERM:
            return NotWritable(path)
        case _:
            return None
