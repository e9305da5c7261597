"""`omnistudy device calibrate --force` at a bought force-feedback stick."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml
from fake_system import FakeSystem, missing

QUICK = (
    "from omnistudy.devices.handheld import measuring_force; measuring_force.PUSH_S = 0.02; "
    "from omnistudy.cli.app import main; main()"
)
READ = (0.2, 2.2, -1.8, 4.2, -3.8)  # 4 N at full, and an instrument that is off by 0.2 N


@pytest.fixture
def system() -> Iterator[FakeSystem]:
    lacking = missing()
    if lacking:
        pytest.skip(f"needs {lacking}")
    fake = FakeSystem("fake_force_stick.py", "full")
    yield fake
    fake.close()


def measure(
    system: FakeSystem, lab: Path, *options: str, sign: float = 1.0
) -> subprocess.CompletedProcess[str]:
    typed = "".join(f"\n{sign * force}\n" for _ in "xy" for force in READ)
    return subprocess.run(
        [sys.executable, "-c", QUICK, "device", "calibrate", "force_stick", "--force",
         "--levels", "2", *options],
        capture_output=True, text=True, timeout=60, input=typed,
        env={**os.environ, **system.environment, "OMNISTUDY_CONF": str(lab)},
    )  # fmt: skip


@pytest.mark.slow
def test_pushes_are_led_through_and_newtons_become_the_page(
    system: FakeSystem, tmp_path: Path
) -> None:
    ran = measure(system, tmp_path, "--instrument", "spring scale")
    assert ran.returncode == 0, ran.stderr
    assert "x, 50% forward: fix the handle to the instrument" in ran.stderr
    page = yaml.safe_load((tmp_path / "device" / "force_stick.yaml").read_text())
    assert page["serial"] == "FF2-0042"
    assert page["strength"]["force"] == pytest.approx(4.0)
    assert page["strength"]["turned"] is False
    assert "spring scale; ± " in page["strength"]["measured"]
    pushed = [one for one in system.say("log") if one["do"] == "upload" and one["kind"] == "push"]
    strongest = [one["direction"] for one in pushed if one["level"] == 0x7FFF]
    assert strongest == [0x8000, 0x0000, 0x4000, 0xC000]  # forward, back, left, right
    assert pushed[-1]["level"] == 0


@pytest.mark.slow
def test_a_stick_that_pushes_the_other_way_is_turned_round(
    system: FakeSystem, tmp_path: Path
) -> None:
    ran = measure(system, tmp_path, "--instrument", "scale", "--dry-run", "--json", sign=-1.0)
    told = json.loads(ran.stdout)
    assert (told["turned"], told["written"]) == (True, False)
    assert yaml.safe_load(told["page"])["strength"]["turned"] is True
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_an_instrument_must_be_named(system: FakeSystem, tmp_path: Path) -> None:
    ran = measure(system, tmp_path)
    assert ran.returncode == 2
    assert "--instrument says what was read" in ran.stderr
