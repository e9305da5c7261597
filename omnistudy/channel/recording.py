"""What a trial leaves behind, as values that any store can write."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel.channel import Channel


class Event(NamedTuple):
    """Something that happened: `t` in s since the trial opened, a kind, a detail for people."""

    t: float
    kind: str
    detail: str = ""


class Stream(NamedTuple):
    """Equally spaced rows of channels.

    data : (rows, len(channels)) float64; row i was taken at i / rate_hz seconds.
    """

    name: str
    rate_hz: float
    channels: tuple[Channel, ...]
    data: NDArray[np.float64]
