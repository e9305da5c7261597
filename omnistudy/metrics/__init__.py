"""Pure metric functions, one file each."""

from omnistudy.metrics.path_length import path_length
from omnistudy.metrics.work_against import work_against

__all__ = ["path_length", "work_against"]
