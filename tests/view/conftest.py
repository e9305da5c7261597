"""A short study of the virtual driver, and a real browser to look at it."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import run_trials
from omnistudy.study import create_study
from omnistudy.view.chromium import Browser, browser

from .meeting import SHORT, Meeting, meeting

FRONT = Path(__file__).parents[2] / "front"
RUN = 2
"""Trials that were run; the third and those after it are planned."""


@pytest.fixture(scope="session")
def driven_study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Give a study whose first two trials were driven."""
    path = tmp_path_factory.mktemp("studies") / "seen.db"
    create_study(compose_protocol("utah2017_component", SHORT), path, "seen")
    run_trials(path, limit=RUN)
    return path


@pytest.fixture(scope="session")
def chromium(requires_program: Callable[[str, str], str]) -> Iterator[Browser]:
    requires_program("chromium", "chromium")
    with browser() as running:
        yield running


@pytest.fixture(scope="session")
def front(
    tmp_path_factory: pytest.TempPathFactory, requires_program: Callable[[str, str], str]
) -> Path:
    """Give a copy of the browser's side with its packages installed as its lock says."""
    npm = requires_program("npm", "nodejs 20 and npm")
    copy = tmp_path_factory.mktemp("checkout") / "front"
    shutil.copytree(FRONT, copy, ignore=shutil.ignore_patterns("node_modules"))
    subprocess.run([npm, "ci", "--no-progress"], cwd=copy, check=True, capture_output=True)
    return copy


@pytest.fixture(scope="module")
def met(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Meeting]:
    with meeting(chromium, tmp_path_factory.mktemp("met")) as met:
        yield met


@pytest.fixture(scope="module")
def met_switch(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Meeting]:
    scanning = ("site.scanning.one_switch=true", "site.scanning.pace=0.3")
    with meeting(chromium, tmp_path_factory.mktemp("switch"), *scanning) as met:
        yield met
