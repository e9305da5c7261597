from __future__ import annotations

import re
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from alembic import command
from alembic.config import Config
from alembic.script import ScriptDirectory

import omnistudy
from omnistudy.errors.store import (
    DatabaseDamaged,
    DatabaseTooNew,
    DatabaseTooOld,
    NotAStudy,
    StudyNotFound,
)
from omnistudy.store import StudyWriter, open_study, sample_digest, upgrade_study
from omnistudy.store.connection import writing_engine
from omnistudy.store.schema import MIGRATIONS, migrate, newest_revision
from omnistudy.store.tables import Base

NEXT_REVISION = """
import sqlalchemy as sa
from alembic import op

revision = "next"
down_revision = {newest!r}


def upgrade():
    op.add_column("event", sa.Column("noticed_by", sa.Text()))
    with op.batch_alter_table("participant", recreate="always") as batch:
        batch.add_column(sa.Column("handedness", sa.Text()))
{ending}
"""


@pytest.fixture
def next_omnistudy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Give a switch that turns this omnistudy into the next one, with one more migration."""
    newest = newest_revision()
    ours = Path(omnistudy.__file__).parent / "store" / "migrations"

    def become(ending: str = "") -> None:
        theirs = tmp_path / "next" / "migrations"
        shutil.copytree(ours, theirs)
        revision = NEXT_REVISION.format(newest=newest, ending=ending)
        (theirs / "versions" / "next.py").write_text(revision)
        monkeypatch.setattr("omnistudy.store.schema.MIGRATIONS", str(theirs))

    return become


@contextmanager
def changed(path: Path) -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(path)) as database, database:
        yield database


def described(connection: sa.Connection) -> dict[str, Any]:
    """Tell all that SQLAlchemy sees of tables, and whether they are WITHOUT ROWID."""
    seen = sa.inspect(connection)
    return {
        table: {
            "columns": [
                (column["name"], str(column["type"]), column["nullable"])
                for column in seen.get_columns(table)
            ],
            "primary key": seen.get_pk_constraint(table),
            "foreign keys": sorted(map(str, seen.get_foreign_keys(table))),
            "unique": sorted(map(str, seen.get_unique_constraints(table))),
            "checks": sorted(map(str, seen.get_check_constraints(table))),
            "indexes": sorted(map(str, seen.get_indexes(table))),
            "options": seen.get_table_options(table),
        }
        for table in seen.get_table_names()
        if table != "alembic_version"
    }


def test_migrations_lead_to_the_tables_in_the_code(tmp_path: Path) -> None:
    (tmp_path / "migrated.db").touch()
    with writing_engine(tmp_path / "migrated.db").begin() as connection:
        migrate(connection)
        migrated = described(connection)
    with sa.create_engine("sqlite://", poolclass=sa.NullPool).begin() as connection:
        Base.metadata.create_all(connection)
        declared = described(connection)
    assert migrated == declared
    assert migrated["sample"]["options"] == {"sqlite_with_rowid": False}
    assert any("ck_trial_status" in check for check in migrated["trial"]["checks"])


def test_a_broken_file_is_not_upgraded(study: Path, next_omnistudy: Any) -> None:
    with changed(study) as database:
        database.execute("UPDATE session SET participant_id = participant_id + 98")
    next_omnistudy()
    with pytest.raises(DatabaseDamaged, match="rows that are not there"):
        upgrade_study(study)
    with pytest.raises(DatabaseTooOld):
        open_study(study)


def test_every_constraint_has_a_name() -> None:
    unnamed = [
        str(constraint)
        for table in Base.metadata.tables.values()
        for constraint in table.constraints
        if not constraint.name
    ]
    assert unnamed == []


def test_there_is_one_line_of_revisions() -> None:
    scripts = ScriptDirectory(str(Path(omnistudy.__file__).parent / "store" / "migrations"))
    assert scripts.get_heads() == [newest_revision()]
    assert scripts.get_bases() == ["0001"]


def test_first_revision_can_be_migrated(tmp_path: Path) -> None:
    """Whatever revisions come, a database of the first one must reach the newest."""
    path = tmp_path / "first.db"
    path.touch()
    with writing_engine(path).begin() as connection:
        alembic = Config(attributes={"connection": connection})
        alembic.set_main_option("script_location", MIGRATIONS)
        command.upgrade(alembic, "0001")
        connection.exec_driver_sql(
            "INSERT INTO study VALUES ('old', 'Old', 'virtual', '{}', 1, ?, ?, ?, '0.1.0')",
            ("d" * 64, "e" * 64, "2026-11-22T06:22:38.125Z"),
        )
        connection.exec_driver_sql(
            "INSERT INTO participant VALUES (1, 'P01', 'virtual', NULL, '0', 'enrolled', ?),"
            " (2, 'P02', 'virtual', NULL, '1', 'enrolled', ?)",
            ("1" * 64, "2" * 64),
        )
    upgrade_study(path)
    with open_study(path) as study:
        assert study.allocations().values.tolist() == [[0, "", "", 0, "P01"], [1, "", "", 1, "P02"]]
        (version,) = study.protocol_versions()
    assert (version.version, version.design_hash, version.reason) == (1, "d" * 64, "first freeze")


def test_older_database_is_refused_with_the_line_to_type(study: Path, next_omnistudy: Any) -> None:
    next_omnistudy()
    with pytest.raises(DatabaseTooOld, match=re.escape(f"`omnistudy study upgrade {study}`")):
        open_study(study)
    with pytest.raises(DatabaseTooOld):
        StudyWriter.open(study)


def test_upgrade_copies_first(driven: Path, next_omnistudy: Any) -> None:
    before = sample_digest(driven)
    old = newest_revision()
    with changed(driven) as database:
        [(size,)] = database.execute("SELECT count(*) FROM event").fetchall()
    next_omnistudy()
    copy = upgrade_study(driven)
    assert copy == driven.with_name(f"small.revision-{old}.db")
    assert sample_digest(driven) == before
    with open_study(driven) as study:
        assert len(study.events()) == size
    with changed(driven) as database:
        assert database.execute("SELECT handedness FROM participant").fetchall() == [(None,)] * 2
        assert len(database.execute("SELECT * FROM trial_overview").fetchall()) == 6
        assert database.execute("PRAGMA foreign_key_check").fetchall() == []
    with changed(copy) as database:
        assert database.execute("SELECT version_num FROM alembic_version").fetchall() == [(old,)]
        assert database.execute("SELECT count(*) FROM event").fetchall() == [(size,)]
    assert upgrade_study(driven) is None


def test_a_second_copy_gets_a_name_of_its_own(study: Path, next_omnistudy: Any) -> None:
    taken = study.with_name(f"small.revision-{newest_revision()}.db")
    taken.write_text("precious")
    next_omnistudy()
    copy = upgrade_study(study)
    assert copy is not None
    assert copy.name == taken.name.replace(".db", "-2.db")
    assert taken.read_text() == "precious"


def test_failed_upgrade_leaves_the_database_as_it_was(study: Path, next_omnistudy: Any) -> None:
    def schema() -> list[Any]:
        with changed(study) as database:
            return database.execute("SELECT sql FROM sqlite_master ORDER BY name").fetchall()

    before = schema()
    next_omnistudy(ending="    raise ZeroDivisionError")
    with pytest.raises(ZeroDivisionError):
        upgrade_study(study)
    assert schema() == before


def test_newer_database_asks_for_a_newer_omnistudy(study: Path) -> None:
    with changed(study) as database:
        database.execute("UPDATE alembic_version SET version_num = 'from_the_future'")
    with pytest.raises(DatabaseTooNew, match="update omnistudy"):
        open_study(study)
    with pytest.raises(DatabaseTooNew, match="from_the_future"):
        StudyWriter.open(study)
    with pytest.raises(DatabaseTooNew):
        upgrade_study(study)


def test_other_databases_are_not_studies(tmp_path: Path) -> None:
    path = tmp_path / "music.db"
    with changed(path) as database:
        database.execute("CREATE TABLE song (name)")
    for opened in (open_study, StudyWriter.open, upgrade_study):
        with pytest.raises(NotAStudy, match="not a study"):
            opened(path)


def test_missing_studies_are_not_made(tmp_path: Path) -> None:
    for opened in (open_study, StudyWriter.open, upgrade_study, omnistudy.open):
        with pytest.raises(StudyNotFound, match="omnistudy study create"):
            opened(tmp_path / "nowhere.db")
    with pytest.raises(StudyNotFound):
        open_study(tmp_path)
    assert list(tmp_path.iterdir()) == []
