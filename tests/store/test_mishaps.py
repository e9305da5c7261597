"""Cut files, spoilt bytes, full disks and killed processes."""

from __future__ import annotations

import os
import signal
import sqlite3
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from sqlalchemy import Engine, event

from omnistudy.errors import OmnistudyError
from omnistudy.errors.store import DatabaseDamaged, NotWritable, StoreFull
from omnistudy.store import NewStudy, StudyWriter, open_study
from omnistudy.store.rows import insert_samples

FinishTrial = Callable[[StudyWriter, int], None]
NOBODY = 65534


def counts(path: Path) -> dict[str, int]:
    with closing(sqlite3.connect(path)) as database:
        assert database.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        return {
            table: database.execute(f"SELECT count(*) FROM {table}").fetchone()[0]
            for table in ("event", "sample", "stream", "chunk")
        }


def status_of(path: Path, trial: int) -> str:
    with StudyWriter.open(path) as opened:
        return next(found.status for found in opened.trials() if found.id == trial)


@contextmanager
def room_for(pages: int) -> Iterator[None]:
    """Let every connection made meanwhile find a disk of so many pages."""

    def limit(database: sqlite3.Connection, _record: object) -> None:
        database.execute(f"PRAGMA max_page_count = {pages}")

    event.listen(Engine, "connect", limit)
    try:
        yield
    finally:
        event.remove(Engine, "connect", limit)


def pages_of(path: Path) -> int:
    return path.stat().st_size // 4096


@pytest.mark.parametrize("kept", [0, 1, 50, 99, 100, 4096, 0.5, -4096, -1])
def test_cut_files_are_damaged(driven: Path, kept: float) -> None:
    whole = driven.read_bytes()
    length = int(kept * len(whole)) if isinstance(kept, float) else kept % len(whole)
    driven.write_bytes(whole[:length])
    for opened in (open_study, StudyWriter.open):
        with pytest.raises(DatabaseDamaged, match="restore it from a backup"):
            opened(driven)
    assert driven.read_bytes() == whole[:length]


def test_other_files_are_damaged(tmp_path: Path) -> None:
    path = tmp_path / "picture.db"
    path.write_bytes(b"\x89PNG" + bytes(500))
    with pytest.raises(DatabaseDamaged, match="no SQLite database"):
        open_study(path)


def test_a_spoilt_first_page_is_noticed_at_once(driven: Path) -> None:
    whole = driven.read_bytes()
    driven.write_bytes(whole[:100] + b"\xff" * 3000 + whole[3100:])
    for opened in (open_study, StudyWriter.open):
        with pytest.raises(DatabaseDamaged):
            opened(driven)


def test_spoilt_pages_are_noticed_when_read(driven: Path) -> None:
    whole = bytearray(driven.read_bytes())
    for page in range(2, pages_of(driven)):
        whole[page * 4096 : page * 4096 + 16] = b"\xff" * 16
    driven.write_bytes(whole)

    def read_all() -> None:
        with open_study(driven) as study:
            study.trials()
            study.samples(1)

    with pytest.raises(DatabaseDamaged):
        read_all()


def test_spoilt_chunks_are_noticed(driven: Path) -> None:
    with closing(sqlite3.connect(driven)) as database, database:
        database.execute("UPDATE chunk SET sha256 = replace(sha256, substr(sha256, 1, 1), 'x')")
    with open_study(driven) as study, pytest.raises(DatabaseDamaged, match=r"trial 1.*SHA-256"):
        study.stream(1, "input")


def test_full_disk_leaves_the_trial_without_any_row(study: Path, finish: FinishTrial) -> None:
    with StudyWriter.open(study) as opened:
        finish(opened, 1)
    before = counts(study)
    with (
        room_for(pages_of(study) + 10),
        StudyWriter.open(study) as opened,
        pytest.raises(StoreFull, match="nothing was half-written"),
    ):
        finish(opened, 2)
    assert counts(study) == before
    assert status_of(study, 2) == "running"
    with StudyWriter.open(study) as opened:
        opened.release_trial(2)
        finish(opened, 2)
    assert counts(study) == {name: 2 * n for name, n in before.items()}


def test_writer_goes_on_after_room_was_made(study: Path, finish: FinishTrial) -> None:
    with room_for(pages_of(study) + 10), StudyWriter.open(study) as opened:
        with pytest.raises(StoreFull):
            finish(opened, 1)
        with opened.transaction():
            opened.connection.exec_driver_sql("PRAGMA max_page_count = 100000")
        opened.release_trial(1)
        finish(opened, 1)
    assert status_of(study, 1) == "completed"


def test_full_disk_leaves_no_new_study(tmp_path: Path, new_study: NewStudy) -> None:
    def create() -> None:
        with StudyWriter.create(tmp_path / "new.db", new_study):
            pass

    for pages in (1, 5, 20):
        with room_for(pages), pytest.raises(StoreFull, match=r"new\.db"):
            create()
        assert list(tmp_path.iterdir()) == []


DIE_WHILE_FINISHING = """
import os, signal, sys
import numpy as np
from omnistudy.channel import Event
from omnistudy.store import StudyWriter, TrialOutcome, writer

writer.insert_streams = lambda *_: os.kill(os.getpid(), signal.SIGKILL)
outcome = TrialOutcome(
    status="completed", reason="", duration_s=1.0, path_length_m=1.0, collisions=0,
    collisions_legacy=0, contact_time_s=0.0,
)
samples = np.random.default_rng(1).normal(size=(4000, 13))
samples[:, 0] = np.arange(4000) / 20
with StudyWriter.open(sys.argv[1]) as opened:
    opened.start_trial(2)
    with opened.transaction():
        # A cache of one page makes SQLite write to the disk long before the end.
        opened.connection.exec_driver_sql("PRAGMA cache_size = 1")
        opened.finish_trial(2, outcome, [Event(0.0, "start")], samples, [])
"""
"""Killed after the samples are written and before the transaction ends."""

DIE_WHILE_CREATING = """
import os, signal, sys
from omnistudy.store import NewStudy, StudyWriter

study = NewStudy(
    name="small", title="", kind="virtual", protocol_json="{}", protocol_version=1,
    design_hash="d" * 64, site_hash="e" * 64,
)
with StudyWriter.create(sys.argv[1], study):
    os.kill(os.getpid(), signal.SIGKILL)
"""


def run_until_killed(program: str, path: Path) -> None:
    child = subprocess.run(
        [sys.executable, "-c", program, str(path)], capture_output=True, text=True, check=False
    )
    assert child.returncode == -signal.SIGKILL, child.stderr


def test_kill_in_the_middle_of_a_trial_keeps_the_database_whole(
    study: Path, finish: FinishTrial
) -> None:
    with StudyWriter.open(study) as opened:
        finish(opened, 1)
    before = counts(study)
    run_until_killed(DIE_WHILE_FINISHING, study)
    log = study.with_name("small.db-wal")
    assert log.stat().st_size > 200_000, "the child should have written into the log"
    with open_study(study) as opened_study:
        assert len(opened_study.trials()) == 6
        assert len(opened_study.samples(2)) == 0
    assert status_of(study, 2) == "running"
    assert counts(study) == before
    with StudyWriter.open(study) as opened:
        opened.release_trial(2)
        finish(opened, 2)
    assert counts(study)["sample"] == 2 * before["sample"]


def test_kill_while_creating_leaves_the_name_free(tmp_path: Path, new_study: NewStudy) -> None:
    path = tmp_path / "new.db"
    run_until_killed(DIE_WHILE_CREATING, path)
    assert not path.exists()
    with StudyWriter.create(path, new_study):
        pass
    with open_study(path) as study:
        assert study.study.name == "small"


@pytest.fixture
def nobody(driven: Path) -> Iterator[Path]:
    """Give a study in a folder that we may read and not write."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = folder / "small.db"
        path.write_bytes(driven.read_bytes())
        path.chmod(0o444)
        folder.chmod(0o555)
        user = os.geteuid()
        if user == 0:
            os.seteuid(NOBODY)
        try:
            yield path
        finally:
            os.seteuid(user)
            folder.chmod(0o755)


def test_a_folder_that_cannot_be_written_can_be_read(nobody: Path, new_study: NewStudy) -> None:
    with open_study(nobody) as study:
        assert len(study.samples(1)) == 200
    assert [entry.name for entry in nobody.parent.iterdir()] == ["small.db"]
    with pytest.raises(NotWritable):
        StudyWriter.open(nobody)
    with (
        pytest.raises(NotWritable, match="check the rights"),
        StudyWriter.create(nobody.with_name("new.db"), new_study),
    ):
        pass


def test_every_message_says_what_to_do() -> None:
    def heirs(kind: type[OmnistudyError]) -> Iterator[type[OmnistudyError]]:
        for heir in kind.__subclasses__():
            if heir.__module__ == "omnistudy.errors.store":
                yield heir

    path = Path("studies/small.db")
    examples: dict[str, tuple[object, ...]] = {
        "DatabaseTooOld": (path, "0001", "0003"),
        "DatabaseTooNew": (path, "0004", "0003"),
        "DatabaseDamaged": (path, "cut"),
        "DiskFailed": (path, "disk I/O error"),
        "WrongTrialStatus": (3, "planned", "finished", ("running",)),
        "NoSuchTrial": (path, 99),
        "NoSuchStream": (3, "inptu", ("input",)),
    }
    for heir in heirs(OmnistudyError):
        message = str(heir(*examples.get(heir.__name__, (path,))))
        assert ":" in message, message
        assert "\n" not in message


def test_samples_are_written_by_the_thousand(study: Path, samples: NDArray[np.float64]) -> None:
    """One statement a batch, never one a row: that is what keeps a trial under 100 ms."""
    statements: list[bool] = []
    with StudyWriter.open(study) as opened:
        event.listen(
            opened.connection,
            "after_cursor_execute",
            lambda *arguments: statements.append(arguments[5]),
        )
        with opened.transaction():
            insert_samples(opened.connection, 1, samples)
    assert statements.count(True) == 1
