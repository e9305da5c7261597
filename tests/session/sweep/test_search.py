from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from small_sweep import ARMS, opened, rows_of, small_plan

from omnistudy.session.sweep import search as searching
from omnistudy.session.sweep.folder import SweepFolder
from omnistudy.session.sweep.planning import SweepPlan
from omnistudy.session.sweep.run import remaining
from omnistudy.session.sweep.search import run_search

WORDS = ("law.stiffness.x=interval(50,500)", "law.stiffness.y=60,120,180", ARMS)


def plan() -> SweepPlan:
    return small_plan(*WORDS, samples=3, objective="duration_s")


def run(folder: SweepFolder, workers: int = 1) -> int:
    told: list[int] = []
    asked = plan()
    assert asked.sweep.search is not None
    run_search(folder, asked, asked.sweep.search, workers, told.append)
    return sum(told)


pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def unbroken(tmp_path_factory: pytest.TempPathFactory) -> SweepFolder:
    folder = opened(tmp_path_factory.mktemp("sweeps") / "search", plan())
    assert run(folder) == 6
    return folder


def test_each_design_point_meets_the_whole_nuisance(unbroken: SweepFolder) -> None:
    rows = rows_of(unbroken)
    assert (
        rows.groupby("design")["operator.arm.stiffness_median"].agg(list).tolist()
        == [[100, 100, 300, 300]] * 3
    )
    assert rows["law.stiffness.x"].between(50, 500).all()
    assert set(rows["law.stiffness.y"]) <= {60, 120, 180}
    assert rows["law.stiffness.x"].nunique() == 3


def test_a_stopped_search_asks_for_the_same_points_and_goes_on(
    tmp_path: Path, unbroken: SweepFolder
) -> None:
    folder = opened(tmp_path / "stopped", plan())
    for name in ("00001-00001.json", "00001-00002.json", "00002-00001.json"):
        shutil.copy(unbroken.results / name, folder.results / name)
    assert remaining(folder, plan().sweep).points == 3
    assert run(folder) == 3
    assert rows_of(folder).equals(rows_of(unbroken))


def test_points_of_an_overtaken_history_are_driven_again(
    tmp_path: Path, unbroken: SweepFolder
) -> None:
    """What was kept under a number that stands for other values now is not told as these."""
    folder = opened(tmp_path / "overtaken", plan())
    shutil.copy(unbroken.results / "00002-00001.json", folder.results / "00001-00001.json")
    text = (folder.results / "00001-00001.json").read_text()
    (folder.results / "00001-00001.json").write_text(text.replace('"design": 2', '"design": 1'))
    assert run(folder) == 6
    assert rows_of(folder).equals(rows_of(unbroken))


@pytest.mark.slow
def test_workers_change_nothing(tmp_path: Path, unbroken: SweepFolder) -> None:
    folder = opened(tmp_path / "two", plan())
    run(folder, workers=2)
    assert rows_of(folder).equals(rows_of(unbroken))


def test_a_search_without_optuna_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(searching, "find_spec", lambda name: None)
    with pytest.raises(searching.OptunaNotInstalled, match=r"pip install 'omnistudy\[optuna\]'"):
        searching.require_optuna()
