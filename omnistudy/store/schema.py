"""Which revision a database has, and how it gets to the newest."""

from __future__ import annotations

from pathlib import Path

from alembic import command
from alembic.config import Config
from alembic.script import ScriptDirectory
from sqlalchemy import Connection, inspect

from omnistudy.errors.store import DatabaseTooNew, DatabaseTooOld, NotAStudy
from omnistudy.store.views import create_views, drop_views

MIGRATIONS = "omnistudy.store:migrations"
"""Where Alembic finds the migrations: a folder packed inside omnistudy."""


def newest_revision() -> str:
    """Give the revision that this omnistudy writes."""
    newest = _scripts().get_current_head()
    assert newest is not None
    return newest


def revision_of(connection: Connection, path: Path) -> str:
    """Give a database's revision; raises NotAStudy when it has none."""
    tables = inspect(connection).get_table_names()
    if not {"alembic_version", "study"} <= set(tables):
        raise NotAStudy(path)
    revision = connection.exec_driver_sql("SELECT version_num FROM alembic_version").scalar()
    if revision is None:
        raise NotAStudy(path)
    return str(revision)


def check_revision(connection: Connection, path: Path) -> None:
    """Raise NotAStudy, DatabaseTooOld or DatabaseTooNew unless the revision is the newest."""
    revision = revision_of(connection, path)
    newest = newest_revision()
    if revision == newest:
        return
    if is_known(revision):
        raise DatabaseTooOld(path, revision, newest)
    raise DatabaseTooNew(path, revision, newest)


def is_known(revision: str) -> bool:
    """Tell whether this omnistudy has a migration with that name."""
    return revision in {script.revision for script in _scripts().walk_revisions()}


def migrate(connection: Connection) -> None:
    """Bring a database, empty or old, to the newest revision inside the open transaction."""
    drop_views(connection)
    configuration = _configuration()
    configuration.attributes["connection"] = connection
    command.upgrade(configuration, "head")
    create_views(connection)


def _configuration() -> Config:
    configuration = Config()
    configuration.set_main_option("script_location", MIGRATIONS)
    return configuration


def _scripts() -> ScriptDirectory:
    return ScriptDirectory.from_config(_configuration())
