"""What goes over the wire between a live trial's server and its pages."""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from websockets.sync.client import ClientConnection, connect

from omnistudy.channel import LatestValue
from omnistudy.view.live_files import CAPACITY, state_file
from omnistudy.view.live_pages import PERIOD_S

from .test_server import TOKEN, served


@pytest.fixture
def study(driven_study: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(driven_study, tmp_path / "wired.db"))


@pytest.fixture
def states(study: Path) -> Iterator[LatestValue]:
    """Give where a session would put its states."""
    value = LatestValue(state_file(study), CAPACITY)
    yield value
    value.remove()


@pytest.fixture
def socket(study: Path, states: LatestValue) -> Iterator[ClientConnection]:
    states.write(b'{"made": 1}')
    with served(study) as address:
        asked = f"ws://{urlsplit(address).netloc}/live?token={TOKEN}"
        with connect(asked, proxy=None) as opened:
            yield opened


PERIODS = 6
"""In which the server looks for a state again and again."""


def heard(socket: ClientConnection) -> Any:
    return json.loads(socket.recv(timeout=30))


def test_a_page_that_is_slow_gets_the_latest_state_and_none_between(
    socket: ClientConnection, states: LatestValue
) -> None:
    assert heard(socket)["state"] == {"made": 1}
    for made in (2, 3, 4):
        states.write(b'{"made": %d}' % made)
        enough = time.monotonic() + PERIODS * PERIOD_S
        while time.monotonic() < enough:
            socket.send('{"clock": 0}')
            assert "clock" in heard(socket), "no state before the last one was taken"
    socket.send('{"took": true}')
    assert heard(socket)["state"] == {"made": 4}


def test_the_session_s_clock_is_told(socket: ClientConnection) -> None:
    heard(socket)
    before = time.monotonic()
    socket.send('{"clock": 12.5}')
    answer = heard(socket)
    assert answer["clock"] == 12.5
    assert before <= answer["at"] <= time.monotonic()
