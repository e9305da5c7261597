"""Where a running session and the server of its pages meet: small files beside the study."""

from __future__ import annotations

from pathlib import Path

CAPACITY = 262_144
"""Bytes that one state or answer may have; a scan of 128 rays makes some 3,000, a questionnaire of
twenty items 10,000."""
KEYS_CAPACITY = 4096
"""Bytes that the held keys may have."""


def state_file(study: Path) -> Path:
    """Give the file through which the session says what is happening."""
    return study.with_name(f"{study.name}-live")


def answer_file(study: Path) -> Path:
    """Give the file through which the server says what its pages answer."""
    return study.with_name(f"{study.name}-answer")
