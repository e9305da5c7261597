"""What `make` says before it installs anything."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
OLD = '#!/bin/sh\n[ "$1" = --version ] && echo Python 3.9.2 && exit 0\nexit 1\n'
NEW_WITHOUT_WHEEL = (
    '#!/bin/sh\ncase "$2" in *platform*) exit 1;; *version_info*) exit 0;; esac\nexit 9\n'
)


@pytest.fixture
def make(
    tmp_path: Path, requires_program: Callable[[str, str], str]
) -> Callable[..., subprocess.CompletedProcess[str]]:
    program = requires_program("make", "make")
    for name in ("Makefile", "requirements.lock", "pyproject.toml"):
        shutil.copy(ROOT / name, tmp_path)
    clean = {n: v for n, v in os.environ.items() if not n.startswith(("MAKE", "MFLAGS", "PYTHON"))}

    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [program, *arguments], cwd=tmp_path, env=clean, capture_output=True, text=True
        )

    return run


def _python(folder: Path, script: str) -> str:
    path = folder / "python"
    path.write_text(script)
    path.chmod(0o755)
    return f"PYTHON={path}"


def test_bare_make_lists_every_target(
    make: Callable[..., subprocess.CompletedProcess[str]],
) -> None:
    listed = {line.split()[0] for line in make().stdout.splitlines()}
    assert {"demo", "test", "quick", "bench", "lock", "system-packages"} <= listed


def test_missing_python_is_one_sentence(
    make: Callable[..., subprocess.CompletedProcess[str]],
) -> None:
    ran = make("demo", "PYTHON=no-such-python")
    assert ran.returncode != 0
    assert "error: there is no no-such-python here" in ran.stdout


def test_old_python_is_one_sentence(
    make: Callable[..., subprocess.CompletedProcess[str]], tmp_path: Path
) -> None:
    ran = make("demo", _python(tmp_path, OLD))
    assert ran.returncode != 0
    assert "is Python 3.9.2, omnistudy needs 3.11 or later" in ran.stdout
    assert not (tmp_path / ".venv").exists()


def test_minutes_of_compiling_are_announced(
    make: Callable[..., subprocess.CompletedProcess[str]], tmp_path: Path
) -> None:
    ran = make("demo", _python(tmp_path, NEW_WITHOUT_WHEEL))
    assert "PyBullet has no ready wheel" in ran.stdout
    assert "minutes" in ran.stdout
