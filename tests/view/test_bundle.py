"""What the browser's side is built to is what the package holds, byte for byte."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

import omnistudy.view

BUILT = Path(omnistudy.view.__file__).parent / "built"
FRONT = Path(__file__).parents[2] / "front"


@pytest.mark.slow
def test_building_again_gives_the_same_bytes(front: Path) -> None:
    npm = shutil.which("npm")
    assert npm is not None
    for script in ("check", "build"):
        done = subprocess.run([npm, "run", script], cwd=front, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
    again = front.parent / "omnistudy" / "view" / "built"
    assert {file.name: file.read_bytes() for file in again.iterdir()} == {
        file.name: file.read_bytes() for file in BUILT.iterdir()
    }, "stale: run `make front`"


def test_lock_names_no_place_to_download_from() -> None:
    lock = json.loads((FRONT / "package-lock.json").read_text(encoding="utf-8"))
    packages = {name: one for name, one in lock["packages"].items() if name}
    assert [name for name, one in packages.items() if "resolved" in one] == []
    assert [name for name, one in packages.items() if "integrity" not in one] == []


def test_what_is_built_in_has_a_permissive_licence() -> None:
    lock = json.loads((FRONT / "package-lock.json").read_text(encoding="utf-8"))
    shipped = {name: one for name, one in lock["packages"].items() if name and not one.get("dev")}
    assert {one["license"] for one in shipped.values()} <= {"MIT", "ISC", "BSD-3-Clause"}
    assert list(shipped) == ["node_modules/three"]


def test_licence_of_what_is_built_in_is_kept() -> None:
    assert "MIT licence" in (BUILT / "view.js").read_text(encoding="utf-8")
    assert "three.js authors" in (BUILT / "three-licence.txt").read_text(encoding="utf-8")
