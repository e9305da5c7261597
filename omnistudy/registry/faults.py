"""From pydantic's validation errors to sentences."""

from __future__ import annotations

from pydantic import ValidationError
from pydantic_core import ErrorDetails


def explain(error: ValidationError, where: str) -> tuple[str, ...]:
    """Say each fault in one sentence: the file, the path in it, what was given, what is allowed.

    where : the file, or whatever else the faulty data came from.
    """
    return tuple(_sentence(fault, where) for fault in error.errors(include_url=False))


def _sentence(fault: ErrorDetails, where: str) -> str:
    return f"{where}: {_path(fault)}: {fault['msg']}"


def _path(fault: ErrorDetails) -> str:
    text = ""
    for part in fault["loc"]:
        text += f"[{part}]" if isinstance(part, int) else f".{part}" if text else str(part)
    return text or "the page"
