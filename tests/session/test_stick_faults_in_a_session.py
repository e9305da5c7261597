"""A stick that fails in a live trial: void with its cause, checked again, and nothing is lost."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from faulty_stick import FaultyStick

import omnistudy
from omnistudy.devices.stick.checks import PRESS_STOP
from omnistudy.devices.stick.toolchain import missing_packages
from omnistudy.errors.stick_checks import ChecksFailed
from omnistudy.registry.kinds import _announced
from omnistudy.session import run_trials
from omnistudy.session.free_drive import DriveParts, drive_protocol
from omnistudy.session.held_devices import HeldDevices
from omnistudy.session.live import RealTime, run_live
from omnistudy.study import create_study
from omnistudy.tasks.free import FreeTask
from omnistudy.trial import Glimpse

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(missing_packages()), reason="needs `make system-packages`"),
]


class Watcher(RealTime):
    """Looks on and never stops a trial."""

    stopped = False

    def see(self, glimpse: Glimpse) -> None:
        return

    def end(self, status: str) -> None:
        return


@pytest.fixture
def announced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The faulty stick as an installed package announces its kind."""
    installed = tmp_path / "faulty-1.0.dist-info"
    installed.mkdir()
    (installed / "METADATA").write_text("Metadata-Version: 2.1\nName: faulty\nVersion: 1.0\n")
    (installed / "entry_points.txt").write_text(
        "[omnistudy.devices]\nfaulty_stick = faulty_stick:FaultyStick\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    _announced.cache_clear()
    yield
    _announced.cache_clear()


def driven(path: Path, told: list[str], **settings: Any) -> None:
    """Run a study of one trial of six seconds with the faulty stick in the virtual hand."""
    parts = DriveParts(
        world="primitive_c", device="emulated_stick", law="component", hand="virtual"
    )
    task = FreeTask(duration=6.0)
    protocol = drive_protocol(parts).model_copy(
        update={"device": FaultyStick(**settings), "task": task}
    )
    create_study(protocol, path, "study")
    run_planned(path, told)


def run_planned(path: Path, told: list[str]) -> None:
    with HeldDevices(path, told.append) as devices:
        run_trials(path, run=lambda ready, specs: run_live(ready, specs, accompany, devices))


def accompany(trial: object) -> Watcher:
    return Watcher()


@pytest.mark.parametrize(
    ("faults", "causes"),
    [
        (("brown_out", "unplug"), ("a brown-out", "nothing was heard")),
        (
            ("slow_telemetry", "other_stick"),
            ("of its telemetry came", "another stick was plugged in"),
        ),
    ],
)
@pytest.mark.usefixtures("announced")
def test_each_fault_voids_its_attempt_and_force_returns_after_the_checks(
    tmp_path: Path, faults: tuple[str, str], causes: tuple[str, str]
) -> None:
    control, path = tmp_path / "faults", tmp_path / "study.db"
    control.write_text("\n".join(faults))
    told: list[str] = []
    driven(path, told, control=control)
    assert control.with_suffix(".duties").read_text() == "0 0 0 0 0 0\n" * 3
    assert told.count(PRESS_STOP) == 3
    with omnistudy.open(path) as study:
        trials = study.trials()
        assert list(trials["status"]) == ["void", "void", "completed"]
        for cause, reason in zip(causes, trials["reason"][:2], strict=True):
            assert cause in reason
        for number in (int(number) for number in trials["trial"]):
            measures = study.measures(number).set_index("name")["value"]
            assert measures["check_emergency_stop_pressed"] == 1.0
            assert measures["zero_shift_x"] == 0.0
            stick = study.stream(number, "stick")
            assert len(stick) >= 250
            assert (np.diff(stick["stick_tick"][:250]) == 1).all()


@pytest.mark.usefixtures("announced")
def test_no_trial_begins_with_a_stick_that_fails_its_checks(tmp_path: Path) -> None:
    path = tmp_path / "study.db"
    told: list[str] = []
    with pytest.raises(ChecksFailed, match="sign of x: did not move"):
        driven(path, told, broken_before="dead_motor")
    with omnistudy.open(path) as study:
        assert "completed" not in set(study.trials()["status"])
        assert study.streams(1).empty
