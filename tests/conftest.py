"""What every test may ask for, and the list of what was skipped that ends each run.

REQUIRE=all in the environment turns every skip into a failure.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Generator, Sequence
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

ROOT = Path(__file__).resolve().parent.parent
SHARED_DATA = ROOT.parent / "shared" / "data"
NOT_RUN = "not run"
"""Name of the property under which a test reports what it left out on purpose."""


# No test depends on how fast or how busy a machine is, nor on luck.
settings.register_profile(
    "omnistudy", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("omnistudy")


@pytest.fixture(autouse=True)
def no_lab(monkeypatch: pytest.MonkeyPatch) -> None:
    """Start without a lab's folder, and forget the one that `--conf` put into the environment."""
    monkeypatch.setenv("OMNISTUDY_CONF", "")


@pytest.fixture(scope="session")
def requires_program() -> Callable[[str, str], str]:
    """Give the path of a program, or skip: `requires_program("chromium", "chromium")`."""

    def find(name: str, debian_package: str) -> str:
        path = shutil.which(name)
        if path is None:
            pytest.skip(f"needs the program {name}: `make system-packages` ({debian_package})")
        return path

    return find


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Give the folder of real data that is no part of the project, or skip."""
    if not SHARED_DATA.is_dir():
        pytest.skip("needs the real data in ../shared/data, which is no part of the project")
    return SHARED_DATA


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    _fail_what_was_skipped(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    _fail_what_was_skipped(report)
    return report


def _fail_what_was_skipped(report: pytest.TestReport | pytest.CollectReport) -> None:
    if os.environ.get("REQUIRE") == "all" and report.skipped:
        report.longrepr = f"{report.nodeid}\nskipped with REQUIRE=all: {_reason(report)}"
        report.outcome = "failed"


def _reason(report: pytest.TestReport | pytest.CollectReport) -> str:
    if isinstance(report.longrepr, tuple):
        return report.longrepr[2].removeprefix("Skipped: ")
    return str(report.longrepr)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    lines = [
        *_skipped(terminalreporter.stats.get("skipped", [])),
        *_left_out(terminalreporter.stats.get("passed", [])),
    ]
    terminalreporter.section("skipped, and why")
    for line in lines or ["nothing"]:
        terminalreporter.write_line(line)


def _skipped(reports: Sequence[pytest.TestReport]) -> list[str]:
    return sorted(f"{report.nodeid}: {_reason(report)}" for report in reports)


def _left_out(reports: Sequence[pytest.TestReport]) -> list[str]:
    return sorted(
        f"{report.nodeid}: {value}"
        for report in reports
        for name, value in report.user_properties
        if name == NOT_RUN
    )
