"""The numbers of docs/laws.md, recomputed; its scenes share nothing with the ray caster."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from laws.straight_walls import RAYS, few_rays, scan_of

from omnistudy.geometry import Scan
from omnistudy.laws.shown import shown
from omnistudy.registry import load_kind
from omnistudy.registry.kinds import BUILT_IN

DOCS = Path(__file__).resolve().parent.parent.parent / "docs"
PAGE = (DOCS / "laws.md").read_text(encoding="utf-8")

PUBLISHED_RANGE = 0.5


def post(others: Scan) -> Scan:
    """Put something at 0.34 m dead ahead into a scene."""
    return Scan(others.angles, np.where(others.angles == 0.0, 0.34, others.ranges), PUBLISHED_RANGE)


SCENES: tuple[Callable[[], Scan], ...] = (
    lambda: scan_of([(1.0, 1.0, 0.65)]),
    lambda: scan_of([(1.0, 0.0, 0.38), (0.0, 1.0, 0.25)]),
    lambda: post(few_rays([((np.cos(ray), np.sin(ray)), PUBLISHED_RANGE) for ray in RAYS])),
    lambda: post(scan_of([(0.0, 1.0, 0.309)], max_range=PUBLISHED_RANGE)),
)
"""The columns of the table, in order."""

ROW = re.compile(r"^\| `(\w+)` \|((?: [-+0-9., ]+ \|){4})$", re.M)


def test_every_law_is_on_the_page() -> None:
    listed = re.findall(r"^\| `(\w+)` \| [A-Zt]", PAGE, re.M)
    assert sorted(listed) == sorted(BUILT_IN["laws"])
    assert sorted(kind for kind, _ in ROW.findall(PAGE)) == sorted({*BUILT_IN["laws"]} - {"none"})


@pytest.mark.parametrize(("kind", "cells"), ROW.findall(PAGE))
def test_the_table_of_wrenches_is_true(kind: str, cells: str) -> None:
    law = load_kind("laws", kind)()
    for scene, cell in zip(SCENES, cells.strip(" |").split("|"), strict=True):
        found = shown(law, scene())
        for printed, value in zip(cell.split(","), (found.fx, found.fy, found.tau), strict=True):
            decimals = len(printed.strip().partition(".")[2])
            assert float(printed) == pytest.approx(value, abs=0.51 * 10**-decimals), (kind, cell)
            assert decimals or value == pytest.approx(0.0, abs=1e-9), (kind, cell)


@pytest.fixture(scope="module")
def pictures() -> ModuleType:
    path = DOCS / "draw_laws.py"
    specification = importlib.util.spec_from_file_location("draw_laws", path)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_what_is_said_of_the_three_drives(pictures: ModuleType) -> None:
    bend, close, corner = (
        {kind: np.array(pictures.torques(load_kind("laws", kind)(), drive))
         for kind in pictures.TURNING}
        for drive in pictures.drives()
    )  # fmt: skip
    assert (bend["spring_damper"] <= 0.0).all()
    for helping in ("component", "quadrant", "quadrant_smoothed"):
        assert (bend[helping] >= 0.0).all()
        assert bend[helping].max() > 0.5

    inside = slice(1, -1)
    assert (close["component"][inside] < 0.0).all()
    assert (close["spring_damper"][inside] > 0.0).all()
    assert np.abs(np.diff(close["quadrant"][inside])).max() > 1.0
    for changing in ("quadrant", "quadrant_smoothed"):
        assert close[changing][inside].min() < -0.5 < 0.3 < close[changing].max()

    assert corner["component"][-1] > 0.5
    assert corner["spring_damper"][-1] < -0.25
    for leaving in ("quadrant", "quadrant_smoothed"):
        assert (corner[leaving] <= 0.0).all()
        assert corner[leaving][-1] < -0.7


def test_no_drive_touches_a_wall(pictures: ModuleType) -> None:
    """Every corner of the robot stays on the robot's side of each wall's line."""
    for drive in pictures.drives():
        for pose in drive.poses:
            corners = [pose.to_world(x, y) for x in (-0.29, 0.29) for y in (-0.19, 0.19)]
            assert all(x < 0.5 and abs(y) < 0.5 for x, y in corners)


@pytest.mark.slow
def test_the_pictures_can_be_drawn_again(pictures: ModuleType, tmp_path: Path) -> None:
    pictures.main(tmp_path)
    shown_on_page = {Path(name).name for name in re.findall(r"\]\((images/\w+\.png)\)", PAGE)}
    assert {path.name for path in tmp_path.iterdir()} == shown_on_page
