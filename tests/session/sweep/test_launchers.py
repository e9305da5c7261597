from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors.sweep import LauncherNotInstalled, UnknownLauncher
from omnistudy.session.sweep import launchers
from omnistudy.session.sweep.launchers import LAUNCHERS, chosen_launcher, cut, settings


@given(
    st.integers(0, 200),
    st.sampled_from(list(LAUNCHERS.values())),
    st.integers(1, 16),
    st.floats(1e-3, 100.0),
)
def test_every_point_is_in_one_job_in_order(
    points: int, launcher: launchers.Launcher, workers: int, seconds: float
) -> None:
    jobs = cut(range(points), launcher, workers, seconds)
    assert [point for job in jobs for point in job] == list(range(points))
    assert all(jobs)


def test_short_points_share_a_job_until_the_overhead_is_small() -> None:
    """At 4 % a fifth of a second is paid by five seconds of trials."""
    jobs = cut(range(500), LAUNCHERS["joblib"], 2, 0.5)
    assert {len(job) for job in jobs} == {10}
    assert {len(job) for job in cut(range(500), LAUNCHERS["joblib"], 2, 30.0)} == {1}


def test_every_worker_gets_a_job() -> None:
    assert len(cut(range(10), LAUNCHERS["joblib"], 4, 0.001)) == 4


def test_jobs_that_all_start_at_once_are_as_many_as_workers() -> None:
    assert len(cut(range(500), LAUNCHERS["submitit_local"], 2, 30.0)) == 2


def test_several_workers_want_joblib() -> None:
    assert chosen_launcher(None, 2).name == "joblib"
    assert chosen_launcher(None, 1).name == "basic"


def test_a_launcher_that_is_not_installed_is_said_with_the_line_to_type(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    missing = replace(LAUNCHERS["joblib"], module="hydra_plugins.not_there")
    monkeypatch.setitem(LAUNCHERS, "joblib", missing)
    with pytest.raises(LauncherNotInstalled, match=r"pip install 'omnistudy\[joblib\]'"):
        chosen_launcher("joblib", 2)
    assert chosen_launcher(None, 2).name == "basic"
    monkeypatch.setitem(LAUNCHERS, "joblib", replace(missing, module="not_there.at_all"))
    assert chosen_launcher(None, 2).name == "basic"


def test_an_unknown_launcher_names_the_nearest() -> None:
    with pytest.raises(UnknownLauncher, match="did you mean 'joblib'"):
        chosen_launcher("jobib", 2)


def test_an_existing_ray_cluster_gets_the_override_that_it_needs() -> None:
    words = settings(LAUNCHERS["ray"], 2, 10.0, "127.0.0.1:6379")
    assert "+hydra.launcher.ray.init.object_store_memory=null" in words
    assert "hydra.launcher.ray.init.address='127.0.0.1:6379'" in words
    assert not any("num_cpus" in word for word in words)


def test_a_queue_gets_four_times_the_expected_time_and_an_hour_at_least() -> None:
    assert "hydra.launcher.timeout_min=60" in settings(LAUNCHERS["submitit_slurm"], 8, 60.0, None)
    words = settings(LAUNCHERS["submitit_slurm"], 8, 36000.0, None)
    assert "hydra.launcher.timeout_min=2400" in words
    assert "hydra.launcher.array_parallelism=8" in words
