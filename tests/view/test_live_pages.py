"""A live session with real pages: they show what happens, and nothing they do changes a trial."""

from __future__ import annotations

import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from view.axe import complaints

import omnistudy
from omnistudy.channel import Event
from omnistudy.protocol.compose import compose_protocol
from omnistudy.store import StudyFile
from omnistudy.study import create_study
from omnistudy.view.captions import captions
from omnistudy.view.chromium import Browser, Tab, browser

from .conftest import SHORT

COMMAND = "from omnistudy.cli.app import main; main()"
STATE = "window.participant.live.state"
SEEN = f"""(() => {{
  const shown = document.querySelector('.message');
  return [{STATE}?.t ?? -1, shown.hidden ? '' : shown.textContent];
}})()"""
AFTERWARDS_S = 0.4
"""Within which a page has drawn what it was told; a busy machine draws a few frames a second."""


@contextmanager
def session(study: Path) -> Iterator[tuple[str, str, subprocess.Popen[str]]]:
    """Run one trial live; gives the addresses of the participant's page and of the monitor."""
    arguments = ("session", "run", str(study), "--trials", "1", "--live", "--no-open")
    with subprocess.Popen(
        [sys.executable, "-c", COMMAND, *arguments], stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stderr is not None
        lines = [process.stderr.readline() for _ in range(2)]
        found = [re.search(r"http://\S+", line) for line in lines]
        try:
            assert found[0], lines
            assert found[1], lines
            yield found[0][0], found[1][0], process
        finally:
            process.terminate()


@pytest.fixture
def study(tmp_path: Path) -> Path:
    path = tmp_path / "seen.db"
    create_study(compose_protocol("utah2017_component", SHORT), path, "seen")
    return path


def events(study: StudyFile) -> list[Event]:
    rows = study.events(1)[["t", "kind", "detail"]].itertuples(index=False, name=None)
    return [Event(*row) for row in rows]


@pytest.mark.slow
def test_five_pages_show_what_happens_and_leave_the_samples_alone(
    study: Path, driven_study: Path, requires_program: Callable[[str, str], str], front: Path
) -> None:
    requires_program("chromium", "chromium")
    seen: list[tuple[float, str]] = []
    with session(study) as (participant, monitor, process):
        with browser() as running:
            screen = opened(running, participant)
            slow = opened(running, monitor)
            slow.ask("Emulation.setCPUThrottlingRate", rate=50)
            watch, *_ = [opened(running, monitor) for _ in range(3)]
            watch.wait_for("document.querySelector('.numbers dd').textContent !== '–'")
            assert "label A" in watch.value("document.querySelector('.where').textContent")
            assert complaints(screen, front) == []
            assert complaints(watch, front) == []
            while screen.value(f"({STATE}?.t ?? 0) < 15"):
                seen.append(tuple(screen.value(SEEN)))
                time.sleep(0.05)
            assert screen.value("window.participant.frames") > 0
            assert [*screen.faults, *slow.faults, *watch.faults] == []
        # The browser is gone; the trial is not.
        assert process.wait(timeout=120) == 0
    with omnistudy.open(study) as live, omnistudy.open(driven_study) as lockstep:
        assert live.sample_array(1).tobytes() == lockstep.sample_array(1).tobytes()
        told = captions(events(live), 1e9)
        remarks = {event.kind for event in events(live)}
    assert {"pace", "display"} <= remarks
    for t, text in seen:
        near = {
            "\n".join(line for one in told if one.begin <= at < one.end for line in one.lines)
            for at in (t - AFTERWARDS_S, t, t + AFTERWARDS_S)
        }
        near |= {"\n".join(one.lines) for one in told if t - AFTERWARDS_S < one.begin <= t}
        assert text in near | {""}, f"at {t} s"
    assert any("Drive away from wall" in text for _, text in seen)


def opened(running: Browser, address: str) -> Tab:
    tab = running.tab(480, 360)
    tab.open(address)
    return tab


@pytest.mark.slow
def test_stop_is_a_key_away_and_ends_the_trial(study: Path, chromium: Browser) -> None:
    with session(study) as (participant, _, process):
        tab = opened(chromium, participant)
        tab.wait_for(f"({STATE}?.t ?? 0) > 1 && !document.querySelector('.stop').disabled")
        assert tab.value("document.activeElement.className") == "stop"
        for kind in ("keyDown", "keyUp"):
            tab.ask("Input.dispatchKeyEvent", type=kind, key="Enter", code="Enter", text="\r")
        tab.wait_for("document.querySelector('.message').textContent.startsWith('Stopped')")
        assert process.wait(timeout=60) == 0
    with omnistudy.open(study) as stored:
        first = stored.trials().iloc[0]
    assert (first["status"], first["reason"]) == ("aborted", "stopped by hand")
    assert not study.with_name(f"{study.name}-live").exists()
