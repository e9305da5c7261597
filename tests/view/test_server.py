"""`omnistudy view` as a process of its own, asked as browsers ask."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from http.client import HTTPConnection, HTTPResponse
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin

from omnistudy.view.chromium import Browser

pytestmark = pytest.mark.slow

COMMAND = "from omnistudy.cli.app import main; main()"
TOKEN = "of-this-test"


@contextmanager
def served(study: Path, *options: str) -> Iterator[str]:
    """Run the command and give the address that it prints."""
    arguments = ("view", str(study), "--no-open", "--token", TOKEN, *options)
    with subprocess.Popen(
        [sys.executable, "-c", COMMAND, *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


@pytest.fixture(scope="module")
def address(driven_study: Path) -> Iterator[str]:
    with served(driven_study) as address:
        yield address


def ask(address: str, path: str, **headers: str) -> tuple[HTTPResponse, str]:
    with closing(HTTPConnection(urlsplit(address).netloc, timeout=30)) as connection:
        connection.request("GET", path, headers=headers)
        with connection.getresponse() as answer:
            return answer, answer.read().decode()


def with_token(address: str) -> dict[str, str]:
    return {"Cookie": f"omnistudy_{urlsplit(address).port}={TOKEN}"}


def test_the_printed_address_keeps_the_token_in_a_cookie(address: str) -> None:
    assert address.endswith(f"?token={TOKEN}")
    answer, _ = ask(address, f"/?token={TOKEN}")
    assert (answer.status, answer.headers["location"]) == (303, "/")
    cookie = answer.headers["set-cookie"].lower()
    assert "httponly" in cookie
    assert "samesite=strict" in cookie


@pytest.mark.parametrize(
    ("path", "headers", "status", "text"),
    [
        ("/", {"Cookie": ""}, 403, "token is missing or wrong"),
        ("/?token=guessed", {"Cookie": ""}, 403, "token is missing or wrong"),
        ("/", {"Origin": "http://evil.example"}, 403, "Only pages of this server"),
        ("/", {"Host": "evil.example"}, 403, "Only pages of this server"),
        ("/trial/99", {}, 404, "has no trial 99"),
        ("/trial/3", {}, 404, "is planned and has no samples"),
        ("/trial/red", {}, 404, "no page /trial/red"),
        ("/trial/1", {}, 200, "fx"),
    ],
)
def test_every_answer_is_clear(
    address: str, path: str, headers: dict[str, str], status: int, text: str
) -> None:
    answer, body = ask(address, path, **{**with_token(address), **headers})
    assert answer.status == status
    assert text in body
    assert "frame-ancestors 'none'" in answer.headers["content-security-policy"]


@pytest.mark.parametrize(("origin", "token"), [("http://evil.example", TOKEN), (None, "guessed")])
def test_live_states_go_to_our_own_pages_alone(
    address: str, origin: str | None, token: str
) -> None:
    socket = f"ws://{urlsplit(address).netloc}/live?token={token}"
    foreign = Origin(origin) if origin else None
    with (
        pytest.raises(InvalidStatus, match="403"),
        connect(socket, origin=foreign, proxy=None),
    ):
        pass
    own = Origin(f"http://{urlsplit(address).netloc}")
    right = f"ws://{urlsplit(address).netloc}/live?token={TOKEN}"
    with connect(right, origin=own, proxy=None) as opened:
        assert json.loads(opened.recv(timeout=30)) == {"state": None, "lag": None}


def test_from_the_list_to_two_trials_side_by_side(address: str, chromium: Browser) -> None:
    tab = chromium.tab()
    tab.open(address)
    tab.wait_for("document.querySelectorAll('tbody tr').length > 2")
    assert tab.value("location.search") == ""
    assert tab.value("document.querySelectorAll('tbody a').length") == 2
    tab.value("document.querySelectorAll('tbody input').forEach((box) => box.click())")
    tab.value("document.querySelector('button').click()")
    tab.wait_for("window.replay !== undefined")
    assert tab.value("location.pathname") == "/trial/1/2"
    assert tab.faults == []


@pytest.mark.parametrize(("options", "head"), [((), "Label A"), (("--unmask",), "Condition none")])
def test_the_list_calls_conditions_as_asked(
    driven_study: Path, chromium: Browser, options: tuple[str, ...], head: str
) -> None:
    cells = "['thead', 'tbody'].map((p) => document.querySelector(p + ' tr').cells[3].textContent)"
    with served(driven_study, *options) as address:
        tab = chromium.tab()
        tab.open(address)
        tab.wait_for("document.querySelectorAll('tbody tr').length > 2")
        assert tab.value(f"{cells}.join(' ')") == head


def test_an_address_that_is_taken_is_said(address: str, driven_study: Path) -> None:
    port = str(urlsplit(address).port)
    again = subprocess.run(
        [sys.executable, "-c", COMMAND, "view", str(driven_study), "--no-open", "--port", port],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert again.returncode == 1
    assert f"port {port}" in again.stderr
    assert "give another --port" in again.stderr
