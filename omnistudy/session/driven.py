"""What a free drive came to."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from omnistudy.channel import Measure
from omnistudy.channel.measure import CHECKED
from omnistudy.store import open_study


@dataclass(frozen=True, slots=True)
class Driven:
    """The last attempt of a drive, and how well it was run; what was checked before is left out.

    duration_s : s from the first command, NaN when there was none. path_length_m : m.
    """

    file: Path
    trial: int
    status: str
    reason: str
    duration_s: float
    path_length_m: float
    collisions: int
    measures: tuple[Measure, ...]


def driven(path: Path) -> Driven | None:
    """Read a drive's study; None as long as nothing was driven."""
    with open_study(path) as study:
        trials = study.trials()
        over = trials[~trials["status"].isin(["planned", "running"])]
        if over.empty:
            return None
        last = over.iloc[-1]
        number = int(last["trial"])
        measures = study.measures(number)
    return Driven(
        file=path,
        trial=number,
        status=str(last["status"]),
        reason=str(last["reason"]),
        duration_s=float(last["duration_s"]),
        path_length_m=float(last["path_length_m"]),
        collisions=int(last["collisions"]),
        measures=tuple(
            Measure(str(row["name"]), float(row["value"]), str(row["unit"]))
            for row in measures.to_dict("records")
            if not str(row["name"]).startswith(CHECKED)
        ),
    )
