"""A live session with real pages: they show what happens, and nothing they do changes a trial."""

from __future__ import annotations

import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest

import omnistudy
from omnistudy.channel import Event
from omnistudy.protocol.compose import compose_protocol
from omnistudy.store import StudyFile
from omnistudy.study import create_study
from omnistudy.view.captions import captions
from omnistudy.view.chromium import FLAGS, Browser, Tab, browser

from .meeting import SHORT

COMMAND = "from omnistudy.cli.app import main; main()"
STATE = "window.participant.live.state"
RECORD = f"""
window.seen = [];
new MutationObserver(() => {{
  if ({STATE}) window.seen.push([{STATE}.t, document.querySelector('.message').textContent]);
}}).observe(document.querySelector('.message'), {{childList: true}});
"""
"""Observers are called before the next state can arrive."""
ONCE_A_SECOND = """
window.strikes = new Set();
window.requestAnimationFrame = (draw) => setTimeout(() => {
  const now = performance.now();
  window.strikes.add(Math.floor(now / 1000));
  draw(now);
}, 1005 - performance.now() % 1000);
"""
"""A page that draws once a second exactly, when its own clock strikes; how hard the machine works
makes no difference to that. (Chromium's CPU throttling slows by a factor, to no certain rate.)"""


@contextmanager
def session(study: Path, *options: str) -> Iterator[tuple[str, str, subprocess.Popen[str]]]:
    """Run one trial live; gives the addresses of the participant's page and of the monitor."""
    arguments = ("session", "run", str(study), "--trials", "1", "--live", "--no-open", *options)
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
def test_sentences_appear_when_their_events_happen(study: Path, chromium: Browser) -> None:
    with session(study, "--no-pauses") as (participant, _, process):
        screen = opened(chromium, participant)
        screen.value(RECORD)
        screen.wait_for("document.querySelector('.message').textContent.startsWith('Drive away')")
        assert not screen.value("document.querySelector('.message').hidden")
        assert screen.value("window.participant.frames") > 0
        seen = screen.value("window.seen")
        assert process.wait(timeout=120) == 0
        assert screen.faults == []
    with omnistudy.open(study) as stored:
        told = captions(events(stored), 1e9)
        remarks = {event.kind for event in events(stored)}
    assert seen
    for t, text in seen:
        lines = [line for one in told if one.begin <= t < one.end for line in one.lines]
        assert text == "\n".join(lines), f"at {t} s"
    assert {"pace", "display"} <= remarks


@pytest.mark.slow
def test_five_pages_a_slow_one_and_a_dead_browser_leave_the_samples_alone(
    study: Path, driven_study: Path, requires_program: Callable[[str, str], str]
) -> None:
    requires_program("chromium", "chromium")
    with ExitStack() as pages:
        running = pages.enter_context(browser())  # first: the trial does not wait for it
        with session(study) as (participant, monitor, process):
            slow = opened(running, participant, ONCE_A_SECOND)
            screen, watch, *_ = [
                opened(running, address) for address in (participant, *3 * (monitor,))
            ]
            watch.wait_for("document.querySelector('.where').textContent.includes('label A')")
            assert [*screen.faults, *watch.faults, *slow.faults] == []
            slow.wait_for(f"window.participant.frames >= 3 && {STATE}.status === 'running'")
            assert slow.value("window.participant.frames <= window.strikes.size")
            pages.close()  # the browser is gone; the trial is not
            assert process.wait(timeout=120) == 0
    with omnistudy.open(study) as live, omnistudy.open(driven_study) as lockstep:
        assert live.sample_array(1).tobytes() == lockstep.sample_array(1).tobytes()


def opened(running: Browser, address: str, before: str = "") -> Tab:
    """Open a page after a script of ours has run in it."""
    tab = running.tab(320, 240)
    tab.ask("Page.addScriptToEvaluateOnNewDocument", source=before)
    tab.open(address)
    return tab


@pytest.mark.slow
@pytest.mark.parametrize(("one_switch", "key"), [(False, "Enter"), (True, "F9")])
def test_stop_is_a_key_away_and_ends_the_trial(
    tmp_path: Path, chromium: Browser, one_switch: bool, key: str
) -> None:
    study = tmp_path / "seen.db"
    overrides = (*SHORT, f"site.scanning.one_switch={one_switch}", "site.scanning.pace=0.3")
    create_study(compose_protocol("utah2017_component", overrides), study, "seen")
    with session(study) as (participant, _, process):
        tab = opened(chromium, participant)
        tab.wait_for(f"({STATE}?.t ?? 0) > 1 && !document.querySelector('.stop').disabled")
        tab.wait_for("document.activeElement.matches('.stop')")
        text = {"text": "\r"} if key == "Enter" else {}
        for kind in ("keyDown", "keyUp"):
            tab.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key, **text)
        tab.wait_for("document.querySelector('.result')?.textContent.startsWith('Stopped')")
        assert process.wait(timeout=60) == 0
    with omnistudy.open(study) as stored:
        first = stored.trials().iloc[0]
    assert (first["status"], first["reason"]) == ("aborted", "stopped by hand")
    assert not study.with_name(f"{study.name}-live").exists()


HEALTH = """Object.fromEntries([...document.querySelectorAll('.health tbody tr')].map(
  (row) => [row.cells[0].textContent, [row.cells[1].textContent, row.cells[2].textContent]]))"""
CLOCK = "(({now, within}) => [now / 1000, within / 1000])(window.monitor.live.clock)"
NUMBERS = """Object.fromEntries([...document.querySelectorAll('.numbers div')].map(
  (one) => [one.children[0].textContent, one.children[1].textContent]))"""


@pytest.mark.slow
def test_the_monitor_tells_how_the_trial_and_the_screen_do(study: Path, chromium: Browser) -> None:
    with session(study) as (participant, monitor, process):
        screen, watch = opened(chromium, participant), opened(chromium, monitor)
        watch.wait_for(f"Number(({NUMBERS}).Collisions) >= 1 && ({HEALTH})['screen lag, p99']")
        where = watch.value("document.querySelector('.where').textContent")
        assert where == "Trial 1 · P01 · label A · through · visit 1, main 1 of 6"
        before = time.monotonic()
        now, within = watch.value(CLOCK)
        assert before - within <= now <= time.monotonic() + within, "page and session agree"
        numbers, health = watch.value(NUMBERS), watch.value(HEALTH)
        assert set(health) == {
            *("late steps", "behind the clock", "age of the last state"),
            *("screen lag, median", "screen lag, p99", "frames shown"),
        }
        assert {state for _, state in health.values()} <= {"ok", "look"}
        assert numbers["Target"] == "finish"
        left = re.fullmatch(r"(\d+):(\d+\.\d) of (\d+):(\d+\.\d)", numbers["Trial, left"])
        assert left
        assert float(left[2]) < float(left[4])
        happened = "document.querySelector('.events').innerText"
        assert "collision" in watch.value(happened)
        coming = watch.value("document.querySelector('.coming').innerText").splitlines()
        assert [line.split(" · ")[0] for line in coming] == [
            f"{place} of 6 label {label}" for place, label in ((2, "B"), (3, "C"), (4, "D"))
        ]
        assert watch.value("window.monitor.scanned.rays.geometry.attributes.position.count") > 2
        assert process.wait(timeout=120) == 0
        assert [*screen.faults, *watch.faults] == []
    with omnistudy.open(study) as stored:
        told = next(event.detail for event in events(stored) if event.kind == "display")
    lag = r"lag [\d.]+ ms median, [\d.]+ ms p99, \d+ frames, clock within [\d.]+ ms"
    assert re.fullmatch(lag, told)


@pytest.mark.slow
def test_without_webgl_the_monitor_still_has_its_numbers(
    study: Path, requires_program: Callable[[str, str], str]
) -> None:
    requires_program("chromium", "chromium")
    plain = tuple(flag for flag in FLAGS if "angle" not in flag and "swiftshader" not in flag)
    flags = (*plain, "--disable-gpu", "--disable-3d-apis")
    with session(study) as (_, monitor, _), browser(flags) as running:
        watch = opened(running, monitor)
        watch.wait_for(f"/^\\d/.test(({NUMBERS}).Time)")
        told = watch.value("document.querySelector('.seen').innerText")
        assert told.startswith("This browser draws no WebGL")
        assert watch.faults == []


CUE = """
window.cues = [];
new MutationObserver(() => {
  const state = window.participant.live.state;
  const cue = document.querySelector('.cue');
  if (state && !cue.hidden) window.cues.push([state.t, cue.querySelector('strong').textContent]);
}).observe(document.querySelector('.cue'), {childList: true, subtree: true});
"""


@pytest.mark.slow
def test_the_next_block_is_named_and_changes_when_it_is_touched(
    tmp_path: Path, chromium: Browser
) -> None:
    study = tmp_path / "seen.db"
    there_and_back = ("world=primitive_a", "routes=[in-and-out]", *SHORT[2:])
    create_study(compose_protocol("utah2017_component", there_and_back), study, "seen")
    with session(study, "--no-pauses") as (participant, _, process):
        screen = opened(chromium, participant)
        screen.value(CUE)
        screen.wait_for("document.querySelector('.cue')?.textContent === 'Next block: finish'", 120)
        told = "document.querySelector('.message').textContent"
        screen.wait_for(f"/^Good Job\\nMove to Next Block/m.test({told})", 10)
        assert process.wait(timeout=180) == 0
        cues = screen.value("window.cues")
        assert screen.faults == []
    with omnistudy.open(study) as stored:
        touched = next(event.t for event in events(stored) if event.kind == "block")
        drawn = [event.detail for event in events(stored) if event.kind == "display"]
    assert [word for _, word in cues] == ["green", "finish"]
    assert cues[0][0] < touched <= cues[1][0] < touched + 1.0
    assert drawn


@pytest.mark.slow
def test_between_two_trials_there_is_a_rest_with_the_result(study: Path, chromium: Browser) -> None:
    with session(study, "--trials", "2") as (participant, _, process):
        screen = opened(chromium, participant)
        screen.wait_for("document.querySelector('.result') !== null", 180)
        text = screen.value("document.querySelector('.sheet').textContent")
        assert re.search(r"Round Complete - Total Collision = \d+", text)
        assert "Time to rest" in text
        for kind in ("keyDown", "keyUp"):
            screen.ask("Input.dispatchKeyEvent", type=kind, key="Enter", code="Enter", text="\r")
        screen.wait_for("document.querySelector('.count') !== null", 20)
        screen.value("document.querySelector('.stop').click()")
        assert process.wait(timeout=60) == 1
        assert process.stderr is not None
        assert "stop was pressed on the countdown page" in process.stderr.read()
    with omnistudy.open(study) as stored:
        statuses = list(stored.trials()["status"])
    assert statuses[0] == "completed"
    assert set(statuses[1:]) == {"planned"}
