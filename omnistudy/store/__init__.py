"""The study database: tables, migrations, the writer and the reader."""

from omnistudy.store.digest import sample_digest
from omnistudy.store.records import (
    Level,
    NewCondition,
    NewParticipant,
    NewStudy,
    NewTrial,
    StoredTrial,
    StudyRecord,
    TrialOutcome,
)
from omnistudy.store.study_file import StudyFile, open_study
from omnistudy.store.upgrade import upgrade_study
from omnistudy.store.writer import StudyWriter

__all__ = [
    "Level",
    "NewCondition",
    "NewParticipant",
    "NewStudy",
    "NewTrial",
    "StoredTrial",
    "StudyFile",
    "StudyRecord",
    "StudyWriter",
    "TrialOutcome",
    "open_study",
    "sample_digest",
    "upgrade_study",
]
