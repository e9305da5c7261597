"""A number about how a trial was run, not about what happened in it."""

from typing import NamedTuple


class Measure(NamedTuple):
    """One number of an attempt, such as how late its steps were: name, value, SI unit."""

    name: str
    value: float
    unit: str
