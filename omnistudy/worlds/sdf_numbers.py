"""Numbers in the text of a Gazebo world."""

from __future__ import annotations

from math import isfinite
from pathlib import Path

from omnistudy.errors.worlds import BrokenSdf


def numbers(file: Path, what: str, text: str, count: int) -> list[float]:
    """Read so many finite numbers; raises BrokenSdf, which names `what`."""
    parts = text.split()
    try:
        found = [float(part) for part in parts]
    except ValueError:
        raise BrokenSdf(file, f"{what} is '{text.strip()}', not numbers") from None
    if not all(isfinite(number) for number in found):
        raise BrokenSdf(file, f"{what} is '{text.strip()}', not finite numbers")
    if len(found) != count:
        raise BrokenSdf(file, f"{what} is '{text.strip()}', where {count} numbers are needed")
    return found
