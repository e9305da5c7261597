"""Pages are found from a wheel, from the editable install, and in a lab's folder."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
SHOW = """
import json, sys
import omnistudy
from omnistudy.protocol.compose import compose_protocol, find_protocol
protocol = compose_protocol("utah2017_component")
print(json.dumps({
    "package": omnistudy.__file__,
    "page": str(find_protocol("utah2017_component")),
    "stiffness": protocol.setup_for("full").law.stiffness.x,
    "walls": len(protocol.world.walls.lines),
}))
"""


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build a wheel and install it into a folder of its own."""
    folder = tmp_path_factory.mktemp("wheel")
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    target = folder / "installed"
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index"]
    subprocess.run([*pip, "--target", str(target), str(wheel)], check=True, capture_output=True)
    return target


def shown(away: Path, **environment: str) -> dict[str, Any]:
    plain = {name: value for name, value in os.environ.items() if name != "OMNISTUDY_CONF"}
    run = subprocess.run(
        [sys.executable, "-c", SHOW],
        cwd=away,
        env=plain | environment,
        capture_output=True,
        text=True,
        check=True,
    )
    found: dict[str, Any] = json.loads(run.stdout)
    assert list(away.iterdir()) == []
    return found


@pytest.fixture
def away(tmp_path: Path) -> Path:
    folder = tmp_path / "away"
    folder.mkdir()
    return folder


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    page = tmp_path / "lab" / "law" / "component.yaml"
    page.parent.mkdir(parents=True)
    page.write_text("kind: component\nstiffness: {x: 1, y: 2, theta: 3}\n")
    return tmp_path / "lab"


@pytest.mark.slow
def test_a_wheel_holds_its_pages_and_finds_them_from_another_folder(
    installed: Path, away: Path
) -> None:
    found = shown(away, PYTHONPATH=str(installed))
    assert Path(found["package"]).parent == installed / "omnistudy"
    assert Path(found["page"]).parent == installed / "omnistudy" / "_conf" / "protocols"
    assert found["walls"] == 44


@pytest.mark.slow
def test_the_labs_page_wins_over_the_wheels(installed: Path, away: Path, lab: Path) -> None:
    ours = shown(away, PYTHONPATH=str(installed))
    labs = shown(away, PYTHONPATH=str(installed), OMNISTUDY_CONF=str(lab))
    assert (ours["stiffness"], labs["stiffness"]) == (pytest.approx(198.5, abs=0.1), 1.0)


@pytest.mark.slow
def test_the_wheel_holds_every_page_and_no_page_twice(installed: Path) -> None:
    packed = {
        str(page.relative_to(installed / "omnistudy" / "_conf"))
        for page in (installed / "omnistudy" / "_conf").rglob("*.yaml")
    }
    ours = {str(page.relative_to(ROOT / "conf")) for page in (ROOT / "conf").rglob("*.yaml")}
    whole = {f"protocols/{page.name}" for page in (ROOT / "protocols").glob("*.yaml")}
    assert packed == ours | whole
    wheel = next(installed.parent.glob("*.whl"))
    names = zipfile.ZipFile(wheel).namelist()
    assert len(names) == len(set(names))


@pytest.mark.slow
def test_the_wheel_holds_the_firmwares_sources_and_nothing_compiled(installed: Path) -> None:
    names = zipfile.ZipFile(next(installed.parent.glob("*.whl"))).namelist()
    packed = [Path(name) for name in names if name.startswith("omnistudy/_firmware/")]
    assert Path("omnistudy/_firmware/src/main.c") in packed
    assert Path("omnistudy/_firmware/emulator/emulator.c") in packed
    assert {path.suffix for path in packed} <= {".c", ".h", ".py", ".yaml", ".md", ""}


@pytest.mark.slow
def test_the_editable_install_finds_the_checkouts_pages(away: Path, lab: Path) -> None:
    ours = shown(away)
    labs = shown(away, OMNISTUDY_CONF=str(lab))
    assert Path(ours["page"]) == ROOT / "protocols" / "utah2017_component.yaml"
    assert labs["stiffness"] == 1.0
