"""A first look at a file before SQLite touches it."""

from __future__ import annotations

from pathlib import Path

from omnistudy.errors.store import DatabaseDamaged, StudyNotFound

HEADER_BYTES = 100
"""Length of the header (SQLite, "Database File Format", sec. 1.3)."""

MAGIC = b"SQLite format 3\x00"


def check_file(path: Path) -> None:
    """Raise StudyNotFound for a missing file, DatabaseDamaged for a cut or foreign one.

    SQLite itself notices missing pages only when it happens to read them.
    """
    if not path.is_file():
        raise StudyNotFound(path)
    with path.open("rb") as file:
        header = file.read(HEADER_BYTES)
    if len(header) < HEADER_BYTES:
        raise DatabaseDamaged(path, f"it holds only {len(header)} bytes")
    if not header.startswith(MAGIC):
        raise DatabaseDamaged(path, "it is no SQLite database")
    if _has_unfinished_log(path):
        # Pages may lie in the log still, and the file may rightly be shorter than it says.
        return
    size = path.stat().st_size
    expected = _page_size(header) * int.from_bytes(header[28:32], "big")
    if size < expected:
        raise DatabaseDamaged(path, f"{expected - size} of its {expected} bytes are missing")


def _page_size(header: bytes) -> int:
    size = int.from_bytes(header[16:18], "big")
    return 65536 if size == 1 else size


def _has_unfinished_log(path: Path) -> bool:
    log = path.with_name(path.name + "-wal")
    return log.exists() and log.stat().st_size > 0
