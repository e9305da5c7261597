"""What a sweep costs besides its trials, and how it scales from one worker to two.

Run alone it prints JSON. Other work on the machine spoils the scaling, hardly the overhead.
"""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from omnistudy.session.sweep.folder import SweepFolder
from omnistudy.session.sweep.job import run_points
from omnistudy.session.sweep.launch import launch
from omnistudy.session.sweep.launchers import LAUNCHERS, cut, settings
from omnistudy.session.sweep.planning import Question, Thinning, plan_sweep
from omnistudy.session.sweep.question import Sweep

ASKED = Question(
    "utah2017_component",
    (
        "law.stiffness.x=range(100,400,50)",
        "operator.arm.stiffness_median=150,250",
        "world=primitive_c",
        "routes=[through]",
        "participants.count=2",
    ),
    thinning=Thinning(trials=1),
)
"""Twelve points of two trials, 20 simulated seconds each: short, so that overhead shows."""

PUBLISHED_POINT_S = 25.0
"""Trials of one point of the published study: eight participants, one trial of 3 s each."""


def figures() -> dict[str, object]:
    """Measure everything; overhead in processor time, which other work hardly changes."""
    sweep = plan_sweep(ASKED).sweep
    places = range(len(sweep.points))
    _driven(sweep)
    trials = _driven(sweep)
    alone = [(place,) for place in places]
    each = _launched(sweep, "basic", 1, alone).processor_s
    jobs = cut(places, LAUNCHERS["basic"], 1, trials / len(places))
    one, two = (_launched(sweep, "joblib", workers, alone).wall_s for workers in (1, 2))
    a_job = (each - trials) / len(places)
    return {
        "overhead_ms_a_job": round(a_job * 1000, 1),
        "overhead_of_a_published_point": round(a_job / PUBLISHED_POINT_S, 4),
        "overhead_of_jobs_as_cut": round(a_job * len(jobs) / trials, 4),
        "overhead_wanted": 0.05,
        "joblib_one_worker_s": round(one, 1),
        "joblib_two_workers_s": round(two, 1),
        "two_workers_of_one": round(one / two, 2),
    }


class Cost(NamedTuple):
    """Time on the clock, and of this process's processor, in s."""

    wall_s: float
    processor_s: float


def _driven(sweep: Sweep) -> float:
    """Give the processor time in s of the trials alone."""
    with TemporaryDirectory() as scratch:
        folder = SweepFolder(Path(scratch) / "sweep")
        folder.open(sweep)
        began = time.process_time()
        run_points(folder, sweep, list(sweep.points))
        return time.process_time() - began


def _launched(sweep: Sweep, launcher: str, workers: int, jobs: Sequence[tuple[int, ...]]) -> Cost:
    """Launch all points in a folder of their own."""
    chosen = LAUNCHERS[launcher]
    with TemporaryDirectory() as scratch:
        folder = SweepFolder(Path(scratch) / "sweep")
        folder.open(sweep)
        wall, processor = time.perf_counter(), time.process_time()
        launch(folder.path, jobs, chosen, settings(chosen, workers, 60.0, None))
        cost = Cost(time.perf_counter() - wall, time.process_time() - processor)
        assert len(folder.done()) == len(sweep.points)
    return cost


if __name__ == "__main__":
    print(json.dumps(figures(), indent=2))
