"""Pure metric functions, one file each."""

from omnistudy.metrics.path_length import path_length

__all__ = ["path_length"]
