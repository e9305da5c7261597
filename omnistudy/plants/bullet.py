"""PyBullet, imported without its greeting on standard error."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def _without_greeting() -> Iterator[None]:
    """PyBullet's C code prints its build time when it loads, past Python's own streams."""
    sys.stderr.flush()
    kept = os.dup(2)
    nothing = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(nothing)
        os.close(kept)


with _without_greeting():
    import pybullet

__all__ = ["pybullet"]
