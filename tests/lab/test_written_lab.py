"""What `omnistudy new` writes is installed, tested, checked and used for real."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from omnistudy.lab import NOUNS, plan_start, write_start

BIN = Path(sys.executable).parent
DOCSTRINGS_OF_TESTS = "D103"
"""Rule that tests need no docstrings for, here as in our own tests."""


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A lab with two things of each noun, one of them with a long name."""
    folder = tmp_path_factory.mktemp("written") / "lab"
    for noun in NOUNS:
        write_start(plan_start(noun, f"grip_{noun}", folder))
        write_start(plan_start(noun, f"one_with_a_long_name_{noun[:2]}", folder))
    return folder


@pytest.fixture(scope="module")
def installed(lab: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The environment in which the lab's package is installed, where nothing else is."""
    folder = tmp_path_factory.mktemp("installed")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index"]
    subprocess.run(
        [*pip, "--no-build-isolation", "--target", str(folder), str(lab)],
        check=True,
        capture_output=True,
    )
    return os.environ | {"PYTHONPATH": str(folder), "OMNISTUDY_CONF": str(lab)}


def done(lab: Path, environment: dict[str, str], program: str, *arguments: str) -> str:
    run = subprocess.run(
        [str(BIN / program), *arguments],
        cwd=lab.parent,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


@pytest.mark.slow
def test_the_written_tests_pass(lab: Path, installed: dict[str, str]) -> None:
    told = done(lab, installed, "pytest", "lab", "-q", "-p", "no:cacheprovider")
    assert "30 passed" in told


@pytest.mark.slow
@pytest.mark.parametrize(
    ("module", "old", "new"),
    [
        ("grip_law", "-self.stiffness * ahead", "self.stiffness * ahead"),
        ("grip_law", "-self.stiffness * aside", "-self.stiffness * ahead"),
        ("grip_law", "return PlanarWrench(0.0, 0.0, 0.0)", "return PlanarWrench(0.0, 0.0, 1e-9)"),
        ("grip_controller", "exp(-dt", "exp(-2 * dt"),
        ("grip_controller", "self.gain * y", "abs(self.gain * y)"),
    ],
)
def test_the_written_tests_notice_a_mistake(
    lab: Path, tmp_path: Path, module: str, old: str, new: str
) -> None:
    text = (lab / "lab_parts" / f"{module}.py").read_text()
    assert old in text
    (tmp_path / "lab_parts").mkdir()
    (tmp_path / "lab_parts" / "__init__.py").write_text("")
    (tmp_path / "lab_parts" / f"{module}.py").write_text(text.replace(old, new, 1))
    run = subprocess.run(
        [str(BIN / "pytest"), f"lab/tests/test_{module}.py", "-q", "-p", "no:cacheprovider"],
        cwd=lab.parent,
        env=os.environ | {"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 1, run.stdout
    assert " failed" in run.stdout


@pytest.mark.slow
def test_an_installed_law_is_listed_shown_and_drawn(lab: Path, installed: dict[str, str]) -> None:
    listed = json.loads(done(lab, installed, "omnistudy", "law", "list", "--json"))
    assert {"kind": "grip_law", "package": "lab_parts"}.items() <= {
        row["kind"]: row for row in listed["kinds"]
    }["grip_law"].items()
    shown = json.loads(done(lab, installed, "omnistudy", "law", "show", "grip_law", "--json"))
    units = {row["name"]: row["unit"] for row in shown["parameters"]}
    assert units["stiffness"] == "N/m"
    done(lab, installed, "omnistudy", "law", "draw", "grip_law", "-o", "grip.svg")
    assert (lab.parent / "grip.svg").stat().st_size > 5000


@pytest.mark.slow
def test_a_study_is_planned_with_what_was_written(lab: Path, installed: dict[str, str]) -> None:
    told = done(
        lab, installed, "omnistudy", "protocol", "check", "grip_protocol",
        "law=grip_law", "controller=grip_controller", "world=grip_world", "routes=[red]",
    )  # fmt: skip
    assert "no faults" in told


@pytest.mark.parametrize("line_length", ["88", "100"])
def test_every_file_is_in_good_form(lab: Path, line_length: str) -> None:
    length = ["--no-cache", "--line-length", line_length]
    done(lab, dict(os.environ), "ruff", "format", "--check", *length, "lab")
    rules = "A,B,C4,D,E,F,I,N,PERF,PIE,PT,PTH,RET,RUF,SIM,UP,W"
    ignored = f"D105,D107,D203,D213,RUF001,RUF002,RUF003,{DOCSTRINGS_OF_TESTS}"
    done(
        lab, dict(os.environ), "ruff", "check", *length, "--select", rules, "--ignore", ignored,
        "lab",
    )  # fmt: skip


@pytest.mark.slow
def test_every_type_is_right(lab: Path, tmp_path: Path) -> None:
    told = done(
        lab, dict(os.environ), "mypy", "--strict", "--config-file=", f"--cache-dir={tmp_path}",
        "lab",
    )  # fmt: skip
    assert "no issues found in 15 source files" in told
