"""A number that is worth recording, with its name and unit."""

from typing import NamedTuple


class Channel(NamedTuple):
    """One recorded quantity: `name` (unique within a trial), SI `unit`, one line of meaning."""

    name: str
    unit: str
    description: str
