"""Every page works by keyboard alone: each control is reached by Tab, and does what it says."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import omnistudy
from omnistudy.view.chromium import Browser, Tab
from omnistudy.view.film import film
from omnistudy.view.page import replay_page, saying_page, write_page

from .keys import go_to, press, tabbed
from .test_server import served

pytestmark = pytest.mark.slow

PLAYER = "window.replay.player"
STAGE = f"{PLAYER}.reels[0].stage"


@pytest.fixture(scope="module")
def page(driven_study: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("keys") / "trial.html"
    with omnistudy.open(driven_study) as study:
        write_page(replay_page([film(study, 1)]), file)
    return file


@pytest.fixture
def replay(chromium: Browser, page: Path) -> Iterator[Tab]:
    tab = chromium.tab(1100, 760)
    tab.open(page.as_uri())
    tab.wait_for("window.replay !== undefined")
    yield tab
    assert tab.faults == []


def test_tab_reaches_every_control_of_a_replay(replay: Tab) -> None:
    controls = "document.querySelectorAll('button:not([hidden]), input:not([type=radio]), select')"
    found = tabbed(replay)
    radios = 1  # a group of them is one stop; arrow keys go on
    assert len(found) == replay.value(f"{controls}.length") + radios
    for name in ("Play", "Time, s", "Follow", "Speed", "Force arrows", "Rays", "Full screen"):
        assert name in found
    assert any("collision" in name for name in found)


def test_each_control_of_a_replay_is_operated(replay: Tab) -> None:
    go_to(replay, "Play")
    press(replay, "Enter")
    assert replay.value(f"{PLAYER}.playing")
    go_to(replay, "Pause")
    press(replay, " ")
    assert not replay.value(f"{PLAYER}.playing")
    go_to(replay, "Time, s")
    press(replay, "Home")
    press(replay, "ArrowRight")
    assert replay.value(f"{PLAYER}.t") == pytest.approx(1.0)
    press(replay, "End")
    assert replay.value(f"{PLAYER}.t") == pytest.approx(replay.value("window.replay.end"))
    go_to(replay, "Follow")
    press(replay, "ArrowRight")
    assert replay.value(f"{STAGE}.view") == "plan"
    go_to(replay, "Speed")
    press(replay, "ArrowDown")
    assert replay.value(f"{PLAYER}.speed") == 2
    go_to(replay, "Force arrows")
    press(replay, " ")
    assert not replay.value(f"{STAGE}.forces.group.visible")
    go_to(replay, "Rays")
    press(replay, " ")
    assert replay.value(f"{PLAYER}.reels[0].scanned.group.visible")
    go_to(replay, "Full screen")
    press(replay, "Enter")
    replay.wait_for("document.fullscreenElement !== null")
    replay.value("document.exitFullscreen()")
    event = next(name for name in tabbed(replay) if "collision" in name)
    go_to(replay, event)
    press(replay, "Enter")
    minutes, seconds = event.split()[0].split(":")
    at = 60 * int(minutes) + float(seconds)
    assert replay.value(f"{PLAYER}.t") == pytest.approx(at, abs=0.051)


def test_the_list_opens_trials_by_keyboard(chromium: Browser, driven_study: Path) -> None:
    with served(driven_study) as address:
        tab = chromium.tab()
        tab.open(address)
        tab.wait_for("document.querySelectorAll('tbody a').length === 2")
        assert tabbed(tab) == [
            *("Monitor", "Trials", "1", "Trial 1 side by side", "2", "Trial 2 side by side"),
        ]
        for name in ("Trial 1 side by side", "Trial 2 side by side"):
            go_to(tab, name)
            press(tab, " ")
        go_to(tab, "Show two side by side")
        press(tab, "Enter")
        tab.wait_for("location.pathname === '/trial/1/2' && window.replay !== undefined")
        tab.open(address)
        go_to(tab, "2")
        press(tab, "Enter")
        tab.wait_for("location.pathname === '/trial/2' && window.replay !== undefined")


def test_the_monitor_works_by_keyboard_when_nothing_runs(
    chromium: Browser, driven_study: Path
) -> None:
    with served(driven_study) as address:
        tab = chromium.tab()
        tab.open(address)
        tab.wait_for("document.querySelector('tbody') !== null")
        go_to(tab, "Monitor")
        press(tab, "Enter")
        tab.wait_for("window.monitor !== undefined")
        assert tab.value("document.querySelector('.where').textContent") == "No trial is running."
        told = tab.value("document.querySelector('.idle').innerText")
        assert "omnistudy session run STUDY --live" in told
        assert tabbed(tab) == [
            *("All trials", "What happened and what comes next", "Numbers and camera", "Plan"),
        ]
        go_to(tab, "Plan")
        press(tab, "ArrowRight")
        assert tab.value("window.monitor.view") == "first"
        go_to(tab, "All trials")
        press(tab, "Enter")
        tab.wait_for("location.pathname === '/'")
        assert tab.faults == []


def test_a_page_that_only_says_something_needs_no_key(chromium: Browser, tmp_path: Path) -> None:
    write_page(saying_page("No such page", "There is none."), tmp_path / "none.html")
    tab = chromium.tab()
    tab.open((tmp_path / "none.html").as_uri())
    tab.wait_for("document.querySelector('h1') !== null")
    assert tabbed(tab) == []
    assert "There is none." in tab.value("document.body.innerText")
