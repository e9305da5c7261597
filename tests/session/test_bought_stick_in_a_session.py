"""A whole session with a force-feedback stick that is unplugged and plugged in again."""

from __future__ import annotations

from pathlib import Path

import pytest
from bought_stick_session import DURATION
from fake_system import missing, preloaded_process

import omnistudy
from omnistudy.devices.handheld.axes import Travel
from omnistudy.devices.handheld.force_stick import ForceStick

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(missing()), reason="needs `make system-packages`"),
]


def run(path: Path, again: str) -> tuple[str, list[dict[str, object]]]:
    with preloaded_process() as process:
        return process.session(path, again)._getvalue()


def test_the_attempt_is_void_the_next_one_drives_and_all_is_told(tmp_path: Path) -> None:
    path = tmp_path / "study.db"
    said, log = run(path, again="log")
    assert said == ""
    with omnistudy.open(path) as study:
        trials = study.trials()
        # a busy machine may void one more: the fake stick's own process has no real time
        assert (trials["status"].iloc[0], trials["status"].iloc[-1]) == ("void", "completed")
        assert (
            "'Fake SideWinder FFB2' (serial number FF2-0042) was unplugged" in trials["reason"][0]
        )
        last = int(trials["trial"].iloc[-1])
        samples = study.samples(last)
        assert samples["stick_x"].max() == pytest.approx(Travel().x)
        assert samples["x"].iloc[-1] - samples["x"].iloc[0] > 0.2
        device = study.devices().iloc[-1]
        assert (device["kind"], device["serial"]) == ("force_stick", "FF2-0042")
        measures = study.measures(last).set_index("name")["value"]
        assert (measures["check_identity"], measures["check_rest"]) == (1.0, 1.0)
        told = study.stream(last, "stick")
        assert len(told) >= 0.5 * DURATION * ForceStick.tick_hz
        assert {"stick_x", "commanded_x", "commanded_y"} <= set(told.columns)
    assert any(one["do"] == "play" for one in log)


def test_another_stick_is_not_taken_for_the_one_that_was_unplugged(tmp_path: Path) -> None:
    path = tmp_path / "study.db"
    said, _ = run(path, again="serial 7 0")
    assert "number FF2-0007) is plugged in where 'Fake SideWinder FFB2' (serial number FF2" in said
    with omnistudy.open(path) as study:
        assert study.trials()["status"].iloc[0] == "void"
