"""`omnistudy device check|monitor|emulate` against each other."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator

import pytest

from omnistudy.devices.stick.toolchain import missing_packages

OMNISTUDY = (sys.executable, "-c", "from omnistudy.cli.app import main; main()")


@pytest.fixture
def port() -> Iterator[str]:
    missing = missing_packages()
    if missing:
        pytest.skip(f"needs {', '.join(missing)}: `make system-packages`")
    emulation = subprocess.Popen(
        [*OMNISTUDY, "device", "emulate", "--hand"], stdout=subprocess.PIPE, text=True
    )
    assert emulation.stdout is not None
    yield emulation.stdout.readline().strip()
    emulation.terminate()
    emulation.wait()
    emulation.stdout.close()


def told(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*OMNISTUDY, "device", *arguments], capture_output=True, text=True, timeout=60
    )


@pytest.mark.slow
def test_the_emulated_stick_is_checked_and_watched(port: str) -> None:
    checked = told("check", port, "--json")
    findings = {one["what"]: one for one in json.loads(checked.stdout)}
    assert findings["firmware"]["sound"]
    assert findings["emergency stop"]["found"] == "released"
    assert checked.returncode == 1  # nobody has given it settings of its own
    watched = told("monitor", port, "--seconds", "0.5")
    assert watched.returncode == 0
    assert "IDLE" in watched.stdout


def test_a_port_that_is_not_there_is_one_sentence() -> None:
    ran = told("check", "/dev/no-such-stick")
    assert ran.returncode == 1
    assert ran.stderr.startswith("error: the port /dev/no-such-stick cannot be opened")
    assert "Traceback" not in ran.stderr
