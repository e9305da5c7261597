"""Declarative studies in which a person drives a robot through a force-feedback joystick."""

from typing import TYPE_CHECKING

from omnistudy.version import VERSION

if TYPE_CHECKING:
    from pathlib import Path

    from omnistudy.store.study_file import StudyFile

__version__ = VERSION


def open(path: "str | Path") -> "StudyFile":  # noqa: A001
    """Open a study database to read: `omnistudy.open("studies/demo.db").trials()`.

    Raises StudyNotFound, DatabaseTooOld, DatabaseTooNew or DatabaseDamaged.
    """
    from omnistudy.store.study_file import open_study

    return open_study(path)
