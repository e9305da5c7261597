"""Measure speed, memory and sameness in one run and print them as JSON: `make bench`.

Seconds depend on the machine and on what else runs there; the ratios are what to compare.
"""

from __future__ import annotations

import json
import os
import platform
import statistics
from importlib.metadata import version

import ceiling
import law_fields
import laws_and_robots
import published_trial
import same_bytes
import startup
import stick
import sweeps

from omnistudy.trial import TrialSpec

ROUNDS = 3


def machine() -> dict[str, object]:
    """Say what it was measured on."""
    return {
        "python": platform.python_version(),
        "pybullet": version("pybullet"),
        "processor": platform.machine(),
        "system": platform.system(),
        "cores": os.cpu_count(),
    }


def trial_speed(spec: TrialSpec) -> dict[str, float]:
    """Measure trial and ceiling in turns, so that both meet the same machine."""
    trials, bare = [], []
    for _ in range(ROUNDS):
        trials.append(published_trial.speed(spec))
        bare.append(ceiling.simulated_seconds_per_second(spec))
    return {
        "trial_simulated_s_per_s": round(statistics.median(trials), 1),
        "trial_wanted": 40.0,
        "ceiling_simulated_s_per_s": round(statistics.median(bare), 1),
        "trial_of_ceiling": round(statistics.median(trials) / statistics.median(bare), 3),
    }


def main() -> None:
    """Measure everything and print one JSON."""
    spec = published_trial.published_trial()
    measured = trial_speed(spec)
    peak = published_trial.in_own_process().peak_megabytes
    print(
        json.dumps(
            {
                "machine": machine(),
                "speed": measured,
                "worker_mb": {"peak": round(peak, 1), "wanted": 300.0},
                "help_s": {"median": round(startup.help_seconds(), 3), "wanted": 0.3},
                "law_field_us": {
                    kind: round(value, 1) for kind, value in law_fields.field_microseconds().items()
                },
                "law_simulated_s_per_s": laws_and_robots.law_speeds(spec),
                "robot_simulated_s_per_s": laws_and_robots.robot_speeds(spec),
                "sweep": sweeps.figures(),
                "stick": stick.figures(),
                "same_seed_same_bytes": same_bytes.checks(),
            },
            indent=2,
        )
    )


if __name__ == "__main__":
    main()
