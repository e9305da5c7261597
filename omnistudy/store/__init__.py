"""The study database: tables, migrations, the writer and the reader."""

from omnistudy.store.digest import sample_digest
from omnistudy.store.records import (
    Level,
    NewAllocation,
    NewCondition,
    NewParticipant,
    NewStudy,
    NewTrial,
    ProtocolVersion,
    StoredTrial,
    StudyRecord,
    TrialOutcome,
)
from omnistudy.store.study_file import StudyFile, open_study
from omnistudy.store.upgrade import upgrade_study
from omnistudy.store.writer import StudyWriter

__all__ = [
    "Level",
    "NewAllocation",
    "NewCondition",
    "NewParticipant",
    "NewStudy",
    "NewTrial",
    "ProtocolVersion",
    "StoredTrial",
    "StudyFile",
    "StudyRecord",
    "StudyWriter",
    "TrialOutcome",
    "open_study",
    "sample_digest",
    "upgrade_study",
]
