"""What a trial came to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import Event, Measure, Stream
from omnistudy.devices import DeviceRecord


@dataclass(frozen=True, slots=True, eq=False)
class TrialResult:
    """Outcome and record of one attempt.

    duration_s : s from the first command to the finish (or to the end of the attempt); NaN when
        nothing was ever commanded.
    path_length_m : m, summed over physics steps.
    collisions : debounced (released by 5 mm for 0.25 s); collisions_legacy : rising edges.
    contact_time_s : s in contact with a wall.
    samples : (n, 13) float64, columns SAMPLE_COLUMNS.
    streams : the rest, among them "input": what each physics step consumed.
    device : what it was driven with; None when it ran from a record.
    measures : how well a live trial was served.
    """

    status: Literal["completed", "timed_out", "void", "aborted"]
    reason: str
    duration_s: float
    path_length_m: float
    collisions: int
    collisions_legacy: int
    contact_time_s: float
    events: tuple[Event, ...]
    samples: NDArray[np.float64]
    streams: tuple[Stream, ...]
    device: DeviceRecord | None = None
    measures: tuple[Measure, ...] = ()
