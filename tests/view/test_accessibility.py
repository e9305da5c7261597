"""Every page passes axe and works by keyboard alone."""

from __future__ import annotations

from pathlib import Path

import pytest
from view.axe import complaints

import omnistudy
from omnistudy.view.chromium import Browser
from omnistudy.view.film import film
from omnistudy.view.page import replay_page, saying_page, trials_page, write_page
from omnistudy.view.trials import trial_list


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
def test_axe_finds_nothing_on_the_replay(
    chromium: Browser, front: Path, driven_study: Path, tmp_path: Path, scheme: str
) -> None:
    page = tmp_path / "trial.html"
    with omnistudy.open(driven_study) as study:
        write_page(replay_page([film(study, 1), film(study, 2)]), page)
    tab = chromium.tab()
    tab.ask(
        "Emulation.setEmulatedMedia",
        features=[{"name": "prefers-color-scheme", "value": scheme}],
    )
    tab.open(f"{page.as_uri()}#t=5")
    tab.wait_for("window.replay !== undefined")
    assert complaints(tab, front) == []
