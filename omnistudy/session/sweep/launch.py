"""Handing jobs to Hydra: its public entry point, called with words as if they were typed."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import hydra
from hydra.core.global_hydra import GlobalHydra

from omnistudy.errors.sweep import LauncherFailed
from omnistudy.registry.conf import LAB_VARIABLE
from omnistudy.session.sweep.job import run_job
from omnistudy.session.sweep.launchers import Launcher
from omnistudy.session.sweep.variables import quoted

FULL_ERROR = "HYDRA_FULL_ERROR"
"""Environment variable without which Hydra prints a trace and exits instead of raising."""


def launch(
    folder: Path, jobs: Sequence[Sequence[int]], launcher: Launcher, settings: Sequence[str]
) -> None:
    """Run jobs, each a list of points, and wait for them; raises LauncherFailed.

    What Hydra and the launcher write stays inside the folder.
    """
    lists = ",".join(f"[{','.join(map(str, job))}]" for job in jobs)
    words = [
        "sweep",
        "--multirun",
        f"hydra/launcher={launcher.name}",
        *settings,
        f"hydra.sweep.dir={quoted(str(folder.resolve() / 'hydra'))}",
        "hydra.sweep.subdir=.",
        "hydra.output_subdir=null",
        "hydra/job_logging=disabled",
        "hydra/hydra_logging=disabled",
        *_lab(),
        f"+folder={quoted(str(folder.resolve()))}",
        f"+points=choice({lists})",
    ]
    entry: Any = hydra.main(config_path=None, version_base="1.3")(run_job)
    with _typed(words), _own_hydra(), _surroundings(launcher, settings):
        try:
            entry()
        except Exception as cause:
            reason = f"{type(cause).__name__}: {' '.join(str(cause).split())[:300]}"
            raise LauncherFailed(launcher.name, reason) from cause


def _lab() -> tuple[str, ...]:
    """Hand the lab's folder to workers that do not inherit the environment."""
    lab = os.environ.get(LAB_VARIABLE)
    return (f"+hydra.job.env_set.{LAB_VARIABLE}={quoted(lab)}",) if lab else ()


@contextmanager
def _typed(words: list[str]) -> Iterator[None]:
    before = sys.argv
    sys.argv = words
    try:
        yield
    finally:
        sys.argv = before


@contextmanager
def _own_hydra() -> Iterator[None]:
    """Leave no Hydra behind, neither ours for it nor its for us."""
    GlobalHydra.instance().clear()
    try:
        yield
    finally:
        GlobalHydra.instance().clear()


@contextmanager
def _surroundings(launcher: Launcher, settings: Sequence[str]) -> Iterator[None]:
    """Set what Hydra and Ray read from the environment; end Ray when it is over."""
    if launcher.name != "ray":
        with _environment({FULL_ERROR: "1"}):
            yield
        return
    with TemporaryDirectory(prefix="ray", ignore_cleanup_errors=True) as logs:
        wanted = {FULL_ERROR: "1"}
        if not any(word.startswith("hydra.launcher.ray.init.address=") for word in settings):
            # A cluster of our own asks for no token, tells nobody, and leaves no logs behind.
            wanted |= {
                "RAY_TMPDIR": logs,
                "RAY_AUTH_MODE": "disabled",
                "RAY_USAGE_STATS_ENABLED": "0",
            }
        with _environment(wanted):
            try:
                yield
            finally:
                import ray

                ray.shutdown()


@contextmanager
def _environment(wanted: Mapping[str, str]) -> Iterator[None]:
    """Set variables that the user has not set."""
    added = {name: value for name, value in wanted.items() if name not in os.environ}
    os.environ.update(added)
    try:
        yield
    finally:
        for name in added:
            del os.environ[name]
