"""What a user can meet, one file a room; every message says what to do."""

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import BrokenKind, NoLabFolder, UnknownKind, nearest

__all__ = ["BrokenKind", "NoLabFolder", "OmnistudyError", "UnknownKind", "nearest"]
