"""Where a running session and the server of its pages meet: two small files beside the study."""

from __future__ import annotations

from pathlib import Path

CAPACITY = 65_536
"""Bytes that one state may have; a scan of 128 rays makes some 3,000."""


def state_file(study: Path) -> Path:
    """Give the file through which the session says what is happening."""
    return study.with_name(f"{study.name}-live")


def answer_file(study: Path) -> Path:
    """Give the file through which the server says what its pages answer."""
    return study.with_name(f"{study.name}-answer")
