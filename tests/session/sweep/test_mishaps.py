"""Sweeps that are killed, and sweeps that go through every launcher: the rows must be the same."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pandas as pd
import pytest
from small_sweep import PROTOCOL, SHORT

GAINS = "law.stiffness.x=100,200,300,400"
ARMS = "operator.arm.stiffness_median=range(100,350,50)"
POINTS = 20

CLUSTER = """
import sys
from ray.cluster_utils import Cluster

node = {"num_cpus": 1, "object_store_memory": 10**8, "include_dashboard": False}
cluster = Cluster(initialize_head=True, head_node_args=node)
cluster.add_node(num_cpus=1, object_store_memory=10**8)
print("address", cluster.address, len(cluster.list_all_nodes()), flush=True)
sys.stdin.read()
cluster.shutdown()
"""

pytestmark = pytest.mark.slow


def surroundings(folder: Path) -> dict[str, str]:
    return os.environ | {"OMNISTUDY_STUDIES": str(folder / "studies"), "HOME": str(folder)}


def words(name: str, *options: str) -> list[str]:
    omnistudy = Path(sys.executable).parent / "omnistudy"
    asked = (PROTOCOL, GAINS, ARMS, *SHORT, "--trials", "1", "--name", name)
    return [str(omnistudy), "sweep", *asked, *options]


def run(folder: Path, name: str, *options: str) -> pd.DataFrame:
    """Run a sweep from the command line; give its table."""
    ran = subprocess.run(
        words(name, *options), cwd=folder, env=surroundings(folder), capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr
    return shown(folder, name)


def shown(folder: Path, name: str) -> pd.DataFrame:
    table = folder / f"{name}.csv"
    omnistudy = Path(sys.executable).parent / "omnistudy"
    subprocess.run(
        [omnistudy, "sweep", "show", name, "--csv", table, "--force"],
        env=surroundings(folder),
        capture_output=True,
        check=True,
    )
    return pd.read_csv(table)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("sweeps")


@pytest.fixture(scope="module")
def unbroken(folder: Path) -> pd.DataFrame:
    rows = run(folder, "unbroken", "--launcher", "basic")
    assert len(rows) == 2 * POINTS
    return rows


def finished(folder: Path, name: str) -> int:
    return len(list((folder / "studies" / "sweeps" / name / "results").glob("*.json")))


def started(folder: Path, name: str, *options: str) -> subprocess.Popen[bytes]:
    """Start a sweep in a process group of its own and wait until two points are finished."""
    process = subprocess.Popen(
        words(name, *options),
        env=surroundings(folder),
        start_new_session=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    while finished(folder, name) < 2:
        with suppress(subprocess.TimeoutExpired):
            process.wait(timeout=0.01)
            pytest.fail("it ended before it could be stopped")
    return process


@pytest.mark.parametrize("launcher", ["basic", "joblib"])
def test_a_killed_sweep_goes_on_by_the_same_command(
    folder: Path, unbroken: pd.DataFrame, launcher: str
) -> None:
    options = ("--launcher", launcher, "--workers", "2")
    process = started(folder, f"killed_{launcher}", *options)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert finished(folder, f"killed_{launcher}") < POINTS
    assert run(folder, f"killed_{launcher}", *options).equals(unbroken)


def test_ctrl_c_keeps_what_was_finished(folder: Path, unbroken: pd.DataFrame) -> None:
    options = ("--launcher", "joblib", "--workers", "2")
    process = started(folder, "stopped", *options)
    os.killpg(process.pid, signal.SIGINT)
    assert process.wait() == 130
    assert 2 <= finished(folder, "stopped") < POINTS
    assert run(folder, "stopped", *options).equals(unbroken)


@pytest.mark.parametrize("launcher", ["joblib", "submitit_local", "ray"])
def test_every_launcher_gives_the_same_rows(
    folder: Path, unbroken: pd.DataFrame, launcher: str
) -> None:
    assert run(folder, launcher, "--launcher", launcher, "--workers", "2").equals(unbroken)
    assert not (folder / ".ray").exists()


@pytest.fixture
def two_nodes(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A Ray cluster of two raylets with one core each, ended with the test."""
    monkeypatch.setenv("RAY_AUTH_MODE", "disabled")
    monkeypatch.setenv("RAY_USAGE_STATS_ENABLED", "0")
    # Ray's sockets lie in this folder, and their paths must be short.
    with tempfile.TemporaryDirectory(prefix="ray", ignore_cleanup_errors=True) as short:
        cluster = subprocess.Popen(
            [sys.executable, "-c", CLUSTER],
            env=surroundings(folder) | {"RAY_TMPDIR": short},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        assert cluster.stdin is not None
        assert cluster.stdout is not None
        with cluster:
            said = next(line for line in cluster.stdout if line.startswith("address"))
            _, address, nodes = said.split()
            assert int(nodes) == 2
            yield address
            cluster.stdin.close()
            cluster.wait()


def test_a_cluster_that_runs_already_gives_the_same_rows(
    folder: Path, unbroken: pd.DataFrame, two_nodes: str
) -> None:
    assert run(folder, "cluster", "--ray-address", two_nodes, "--workers", "2").equals(unbroken)
    assert not (folder / ".ray").exists()
