"""What a launcher runs: some points of a sweep, each kept as soon as it is driven."""

from __future__ import annotations

import time
from functools import cache
from pathlib import Path
from typing import Any

from omnistudy.session.sweep.driven import drive_point
from omnistudy.session.sweep.folder import SweepFolder
from omnistudy.session.sweep.question import Point, Sweep


def run_job(job: Any) -> None:
    """Drive the points of one Hydra job that are still wanted.

    job : Hydra's configuration with `folder` and `points`, 0-based places in the sweep's list.
    """
    sweep = _question(str(job.folder))
    run_points(SweepFolder(Path(job.folder)), sweep, [sweep.points[index] for index in job.points])


def run_points(folder: SweepFolder, sweep: Sweep, points: list[Point]) -> None:
    """Drive points; what fails is written down and the next one is tried."""
    for point in points:
        if folder.kept(point.design, point.nuisance) is not None:
            continue  # a job that outlived its launcher was here first
        began = time.perf_counter()
        try:
            rows = drive_point(sweep, point)
        except Exception as error:
            # Told at the end of the sweep: one point must not lose the others.
            folder.keep_failure(point, error)
        else:
            folder.keep(point, rows, time.perf_counter() - began)


@cache
def _question(folder: str) -> Sweep:
    """Read a sweep once a process: it never changes."""
    return SweepFolder(Path(folder)).question()
