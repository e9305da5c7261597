from __future__ import annotations

import json
from pathlib import Path

import pytest
from small_sweep import ARMS, GAINS, opened, question, rows_of, small_plan

from omnistudy.errors.sweep import AnotherQuestion, BrokenSweep, JobsFailed
from omnistudy.session.sweep.folder import SweepFolder
from omnistudy.session.sweep.job import run_points
from omnistudy.session.sweep.launchers import LAUNCHERS
from omnistudy.session.sweep.planning import SweepPlan, plan_sweep
from omnistudy.session.sweep.run import remaining, run_sweep


def run_all(folder: SweepFolder, plan: SweepPlan) -> list[int]:
    """Run what is left in this process; give what progress was told."""
    told: list[int] = []
    left = remaining(folder, plan.sweep)
    run_sweep(folder, plan.sweep, left, LAUNCHERS["basic"], 1, finished=told.append)
    return told


@pytest.fixture(scope="module")
def unbroken(tmp_path_factory: pytest.TempPathFactory) -> SweepFolder:
    folder = opened(tmp_path_factory.mktemp("sweeps") / "unbroken", small_plan())
    assert sum(run_all(folder, small_plan())) == 4
    return folder


def test_the_table_has_one_row_a_trial(unbroken: SweepFolder) -> None:
    rows = rows_of(unbroken)
    keys = ["law.stiffness.x", "operator.arm.stiffness_median"]
    assert [tuple(row) for row in rows[["design", "nuisance", *keys]].itertuples(index=False)] == [
        (design, nuisance, gain, arm)
        for design, gain in ((1, 100), (2, 400))
        for nuisance, arm in ((1, 100), (2, 300))
        for _ in ("P01", "P02")
    ]
    assert set(rows["status"]) == {"timed_out"}
    assert (rows["work_against_j"] > 0).all()


def test_every_point_meets_the_same_people_on_the_same_routes(unbroken: SweepFolder) -> None:
    columns = ["participant", "position", "condition", "route"]
    met = [list(group[columns].itertuples(index=False)) for _, group in rows_of(unbroken).groupby(
        ["design", "nuisance"])]  # fmt: skip
    assert all(one == met[0] for one in met)


def test_hydra_writes_nothing_outside_the_sweeps_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    awkward = tmp_path / "it's a folder, = {odd}"
    folder = opened(awkward / "sweep", small_plan())
    run_all(folder, small_plan())
    assert list(here.iterdir()) == []
    assert {path.name for path in folder.path.iterdir()} == {
        "sweep.json", "results", "failed", "hydra",
    }  # fmt: skip
    assert [path.name for path in (folder.path / "hydra").iterdir()] == ["multirun.yaml"]


def test_a_point_that_another_job_finished_is_not_driven_again(unbroken: SweepFolder) -> None:
    before = {path: path.stat().st_mtime_ns for path in unbroken.results.iterdir()}
    run_points(unbroken, small_plan().sweep, list(small_plan().sweep.points))
    assert {path: path.stat().st_mtime_ns for path in unbroken.results.iterdir()} == before


@pytest.mark.slow
def test_a_stopped_sweep_goes_on_and_comes_to_the_same(
    tmp_path: Path, unbroken: SweepFolder
) -> None:
    plan = small_plan()
    folder = opened(tmp_path / "stopped", plan)
    run_all(folder, plan)
    folder.drop(1, 2)
    folder.drop(2, 1)
    kept = {path.name: path.stat().st_mtime_ns for path in folder.results.iterdir()}
    assert remaining(folder, plan.sweep).places == (1, 2)
    assert sum(run_all(folder, plan)) == 2
    assert rows_of(folder).equals(rows_of(unbroken))
    now = {path.name: path.stat().st_mtime_ns for path in folder.results.iterdir()}
    assert kept.items() <= now.items(), "what was finished is not driven again"


def test_a_failing_point_does_not_lose_the_others_and_is_tried_again(tmp_path: Path) -> None:
    """One of two recordings is not there yet."""
    here, missing = tmp_path / "here.csv", tmp_path / "missing.csv"
    here.write_text("time,x\n0,0.01\n1,0.02\n1.5,0.02\n")
    recordings = (
        "operator=recorded",
        "operator.axes=[x,null,null]",
        f"operator.file='{missing}','{here}'",
    )
    plan = plan_sweep(question(*recordings))
    folder = opened(tmp_path / "failing", plan)
    with pytest.raises(JobsFailed, match=r"1 point of sweep 'failing' failed.*missing\.csv"):
        run_all(folder, plan)
    assert folder.done() == {(1, 2)}
    (failure,) = folder.errors()
    assert (failure.design, failure.nuisance) == (1, 1)
    assert "Traceback" in failure.trace

    missing.write_text(here.read_text())
    assert remaining(folder, plan.sweep).places == (0,)
    assert run_all(folder, plan) == [1]
    assert (folder.done(), folder.errors()) == ({(1, 1), (1, 2)}, ())


def test_another_question_under_the_same_name_is_refused(unbroken: SweepFolder) -> None:
    unbroken.open(plan_sweep(question(GAINS, ARMS)).sweep)
    with pytest.raises(AnotherQuestion, match="differs: seed"):
        unbroken.open(plan_sweep(question(GAINS, ARMS, seed="other")).sweep)


def test_a_file_that_is_not_a_sweeps_is_said(tmp_path: Path) -> None:
    folder = opened(tmp_path / "broken", small_plan())
    (folder.results / "00001-00001.json").write_text("{")
    with pytest.raises(BrokenSweep, match=r"00001-00001\.json cannot be read"):
        folder.finished()
    (folder.path / "sweep.json").write_text(json.dumps({"version": 1}))
    with pytest.raises(BrokenSweep, match=r"sweep\.json cannot be read"):
        folder.question()
