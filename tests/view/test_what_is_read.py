"""What a person reads in the browser when there is nothing to be shown."""

from __future__ import annotations

import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import pytest

from omnistudy.view.chromium import Browser, Tab

from .test_server import served

pytestmark = pytest.mark.slow

READ = "document.querySelector('main').innerText"


@pytest.fixture(scope="module")
def copied(driven_study: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Give a study of this module alone."""
    return Path(shutil.copy(driven_study, tmp_path_factory.mktemp("read") / "read.db"))


@pytest.fixture(scope="module")
def address(copied: Path) -> Iterator[str]:
    with served(copied) as address:
        yield address


@pytest.fixture
def tab(chromium: Browser) -> Tab:
    """Give a tab of a browser that was never here."""
    tab = chromium.tab()
    tab.ask("Network.clearBrowserCookies")
    return tab


def site(address: str) -> str:
    return f"http://{urlsplit(address).netloc}"


def read(tab: Tab, address: str) -> str:
    tab.open(address)
    tab.wait_for("document.querySelector('main') !== null")
    return str(tab.value(READ))


def test_a_wrong_token_is_answered_with_where_the_right_one_is(tab: Tab, address: str) -> None:
    told = read(tab, f"{site(address)}/?token=guessed")
    assert told.startswith("The token is missing or wrong")
    assert "Open the address that the command printed" in told


def test_an_unknown_trial_and_a_planned_one_say_which_there_are(tab: Tab, address: str) -> None:
    tab.open(address)
    assert "has no trial 99" in read(tab, f"{site(address)}/trial/99")
    told = read(tab, f"{site(address)}/trial/3")
    assert "is planned and has no samples to show" in told
    assert "omnistudy session run" in told
    assert "the study's trials are listed on the first" in read(tab, f"{site(address)}/nowhere")


def test_another_page_gets_nothing_and_is_told_so(tab: Tab, address: str, tmp_path: Path) -> None:
    tab.open(address)
    elsewhere = tmp_path / "elsewhere.html"
    elsewhere.write_text(f"<form method=post action='{address}'><button>ask</button></form>")
    tab.open(elsewhere.as_uri())
    asking = f"fetch('{address}', {{credentials: 'include'}}).then(() => 'answered', () => 'none')"
    assert tab.value(asking) == "none"
    socket = address.replace("http", "ws").replace("/?", "/live?")
    listening = (
        f"new Promise((told) => {{ const s = new WebSocket('{socket}');"
        " s.onopen = () => told('open'); s.onerror = () => told('refused'); })"
    )
    assert tab.value(listening) == "refused"
    tab.value("document.querySelector('button').click()")
    tab.wait_for("document.querySelector('main') !== null")
    assert "Only pages of this server may talk to it" in tab.value(READ)


@contextmanager
def in_use(study: Path) -> Iterator[None]:
    """Hold a database for oneself, as a program does that repairs or converts it."""
    with closing(sqlite3.connect(study, isolation_level=None)) as holder:
        holder.execute("PRAGMA locking_mode = EXCLUSIVE")
        holder.execute("BEGIN EXCLUSIVE")
        yield
        holder.execute("ROLLBACK")


def test_a_database_in_use_is_said_and_shown_once_it_is_free(
    tab: Tab, address: str, copied: Path
) -> None:
    """The store waits ten seconds for whoever has it before it gives up."""
    tab.open(address)
    with in_use(copied):
        told = read(tab, f"{site(address)}/trial/1")
        status = tab.value("performance.getEntriesByType('navigation')[0].responseStatus")
    assert status == 503
    assert told.startswith("This cannot be shown")
    assert "another program has" in told
    assert "wait until it is done" in told
    tab.open(f"{site(address)}/trial/1")
    tab.wait_for("window.replay !== undefined")
