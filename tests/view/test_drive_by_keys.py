"""A person drives with the keys of the participant's page, and the drive is kept."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import omnistudy
from omnistudy.view.chromium import Browser, Tab
from omnistudy.view.film import film
from omnistudy.view.trials import trial_list

COMMAND = "from omnistudy.cli.app import main; main()"
STATE = "window.participant.live.state"
FORWARD = {"key": "ArrowUp", "code": "ArrowUp", "windowsVirtualKeyCode": 38}


@pytest.mark.slow
def test_held_keys_drive_the_robot_and_stop_ends_it(tmp_path: Path, chromium: Browser) -> None:
    file = tmp_path / "mine.db"
    words = ("drive", "primitive_a", "--device", "keyboard", "--law", "none", "--no-open")
    with subprocess.Popen(
        [sys.executable, "-c", COMMAND, *words, "--output", str(file)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            tab = _participant(chromium, process)
            began = tab.value(f"{STATE}.values.x")
            tab.ask("Input.dispatchKeyEvent", type="rawKeyDown", **FORWARD)
            tab.wait_for(f"{STATE}.values.x < {began} - 0.2")  # the robot looks that way
            tab.ask("Input.dispatchKeyEvent", type="keyUp", **FORWARD)
            tab.wait_for(f"Math.abs({STATE}.values.stick_x) < 1e-9")
            tab.value("document.querySelector('.stop').click()")
            told, complained = process.communicate(timeout=60)
        finally:
            process.terminate()
    assert process.returncode == 0, complained
    assert told.startswith("aborted (stopped by hand)")
    with omnistudy.open(file) as study:
        assert not film(study, 1).virtual, "a person drove"
        assert not trial_list(study).virtual
        samples = study.samples(1)
        (device,) = study.devices().to_dict("records")
    assert samples["x"].iloc[0] - samples["x"].min() > 0.2
    assert samples["stick_x"].max() > 0.0 == samples["stick_y"].abs().max()
    assert (device["kind"], device["wrench"], device["pushes"]) == ("keyboard", "none", "")


def _participant(chromium: Browser, process: subprocess.Popen[str]) -> Tab:
    """Open the participant's page, whose address the command says, once the trial runs."""
    assert process.stderr is not None
    found = re.search(r"participant: (http://\S+)", process.stderr.readline())
    assert found
    tab = chromium.tab(640, 480)
    tab.open(found[1])
    tab.wait_for(f"({STATE}?.t ?? 0) > 0.2 && {STATE}.status === 'running'")
    return tab
