"""Hydra's launchers: what they need, and how a job is cut for them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from math import ceil

from omnistudy.errors.sweep import LauncherNotInstalled, UnknownLauncher


@dataclass(frozen=True, slots=True)
class Launcher:
    """One of Hydra's launchers.

    module : whose absence means that it is not installed. extra : of omnistudy that brings it.
    overhead_s : what a job costs besides its trials (benchmarks/sweeps.py).
    all_at_once : every job starts at once, so there must be as many jobs as workers.
    """

    name: str
    module: str = "hydra"
    extra: str = ""
    overhead_s: float = 0.2
    all_at_once: bool = False


LAUNCHERS = {
    launcher.name: launcher
    for launcher in (
        Launcher("basic"),
        Launcher("joblib", "hydra_plugins.hydra_joblib_launcher", "joblib"),
        Launcher(
            "submitit_local",
            "hydra_plugins.hydra_submitit_launcher",
            "slurm",
            5.0,
            all_at_once=True,
        ),
        Launcher("submitit_slurm", "hydra_plugins.hydra_submitit_launcher", "slurm", 10.0),
        Launcher("ray", "hydra_plugins.hydra_ray_launcher", "ray", 0.4),
    )
}

OVERHEAD_SHARE = 0.04
"""Part of a job's trials that its overhead may cost."""


def chosen_launcher(name: str | None, workers: int) -> Launcher:
    """Give a launcher; without a name joblib for several workers, if it is installed.

    Raises UnknownLauncher, LauncherNotInstalled.
    """
    if name is None:
        return LAUNCHERS["joblib" if workers > 1 and _installed(LAUNCHERS["joblib"]) else "basic"]
    if name not in LAUNCHERS:
        raise UnknownLauncher(name, list(LAUNCHERS))
    launcher = LAUNCHERS[name]
    if not _installed(launcher):
        raise LauncherNotInstalled(name, launcher.extra)
    return launcher


def cut(
    points: Sequence[int], launcher: Launcher, workers: int, seconds_a_point: float
) -> tuple[tuple[int, ...], ...]:
    """Cut points into jobs: long enough for their overhead, short enough for every worker."""
    if not points:
        return ()
    share = ceil(len(points) / workers)
    enough = ceil(launcher.overhead_s / OVERHEAD_SHARE / max(seconds_a_point, 1e-6))
    length = share if launcher.all_at_once else min(share, enough)
    return tuple(tuple(points[i : i + length]) for i in range(0, len(points), length))


def settings(
    launcher: Launcher, workers: int, expected_s: float, ray_address: str | None
) -> tuple[str, ...]:
    """Give Hydra's overrides for a launcher.

    expected_s : for all jobs together; a queue gets four times as much, at least an hour.
    """
    minutes = max(60, ceil(4 * expected_s / 60))
    if launcher.name == "joblib":
        return (f"hydra.launcher.n_jobs={workers}", "hydra.launcher.batch_size=1")
    if launcher.name == "submitit_local":
        return (f"hydra.launcher.timeout_min={minutes}",)
    if launcher.name == "submitit_slurm":
        return (
            f"hydra.launcher.timeout_min={minutes}",
            f"hydra.launcher.array_parallelism={workers}",
            "hydra.launcher.cpus_per_task=1",
        )
    if launcher.name == "ray":
        return _ray(workers, ray_address)
    return ()


def _ray(workers: int, address: str | None) -> tuple[str, ...]:
    quiet = ("+hydra.launcher.ray.init.log_to_driver=false",)
    if address is not None:
        # The launcher sets a memory that Ray refuses for a cluster which exists already.
        return (
            f"hydra.launcher.ray.init.address='{address}'",
            "+hydra.launcher.ray.init.object_store_memory=null",
            *quiet,
        )
    return (
        f"+hydra.launcher.ray.init.num_cpus={workers}",
        "+hydra.launcher.ray.init.include_dashboard=false",
        *quiet,
    )


def _installed(launcher: Launcher) -> bool:
    try:
        return find_spec(launcher.module) is not None
    except ModuleNotFoundError:
        return False


def cores() -> int:
    """Count the cores of this machine."""
    return os.cpu_count() or 1
