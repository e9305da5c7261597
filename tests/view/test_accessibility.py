"""Every page passes axe and works by keyboard alone."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from view.axe import complaints
from view.test_live_pages import session
from view.test_server import served

import omnistudy
from omnistudy.view.chromium import Browser, Tab
from omnistudy.view.film import film
from omnistudy.view.page import replay_page, saying_page, trials_page, write_page
from omnistudy.view.trials import trial_list


def in_scheme(tab: Tab, scheme: str) -> Tab:
    """Give the tab as it is for whoever likes it light, or dark."""
    wish = {"name": "prefers-color-scheme", "value": scheme}
    tab.ask("Emulation.setEmulatedMedia", features=[wish])
    return tab


@pytest.mark.slow
def test_axe_finds_nothing_on_the_list_and_on_a_refusal(
    chromium: Browser, front: Path, driven_study: Path, tmp_path: Path
) -> None:
    with omnistudy.open(driven_study) as study:
        write_page(trials_page(trial_list(study)), tmp_path / "list.html")
    write_page(saying_page("No such page", "There is none."), tmp_path / "none.html")
    for name in ("list.html", "none.html"):
        tab = chromium.tab()
        tab.open((tmp_path / name).as_uri())
        tab.wait_for("document.querySelector('h1') !== null")
        assert complaints(tab, front) == []


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("path", ["monitor", "participant", "", "trial/99"])
def test_axe_finds_nothing_on_pages_that_wait(
    chromium: Browser, front: Path, driven_study: Path, scheme: str, path: str
) -> None:
    with served(driven_study) as address:
        tab = in_scheme(chromium.tab(), scheme)
        tab.open(address)
        tab.open(f"{address.split('?')[0]}{path}")
        tab.wait_for("document.querySelector('main') !== null")
        assert complaints(tab, front) == []
        assert tab.faults == []


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_on_the_pages_of_a_trial(
    chromium: Browser, front: Path, driven_study: Path, tmp_path: Path, scheme: str
) -> None:
    study = tmp_path / "again.db"
    shutil.copy(driven_study, study)
    with session(study) as (participant, monitor, _):
        screen, tab = (in_scheme(chromium.tab(640, 480), scheme) for _ in range(2))
        screen.open(participant)
        tab.open(monitor)
        tab.wait_for("document.querySelectorAll('.health tbody tr').length === 6")
        assert complaints(tab, front) == []
        assert complaints(screen, front) == []


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_on_the_replay(
    chromium: Browser, front: Path, driven_study: Path, tmp_path: Path, scheme: str
) -> None:
    page = tmp_path / "trial.html"
    with omnistudy.open(driven_study) as study:
        write_page(replay_page([film(study, 1), film(study, 2)]), page)
    tab = in_scheme(chromium.tab(), scheme)
    tab.open(f"{page.as_uri()}#t=5")
    tab.wait_for("window.replay !== undefined")
    assert complaints(tab, front) == []
