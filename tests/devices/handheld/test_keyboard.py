"""Keys that a page says are held."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from omnistudy.channel import LatestValue
from omnistudy.devices import NO_HAND
from omnistudy.devices.handheld.axes import Travel
from omnistudy.devices.handheld.held_keys import HeldKeys
from omnistudy.devices.handheld.keyboard import Keyboard, keys_file
from omnistudy.errors.handheld import NoKeys

FULL = Travel()


class Page:
    """The page's server, and a clock that stands still until it is moved on."""

    def __init__(self, study: Path) -> None:
        self.file = LatestValue(keys_file(study), 4096)
        self.now = 100.0

    def hold(self, *keys: str) -> None:
        self.file.write(json.dumps({"at": self.now, "held": keys}).encode())

    def clock(self) -> float:
        return self.now


@pytest.fixture
def study(tmp_path: Path) -> Path:
    return tmp_path / "study.db"


def levers(study: Path, page: Page, **settings: float) -> HeldKeys:
    keyboard = Keyboard(**settings).at(study)
    assert keyboard.file is not None
    return HeldKeys(keyboard.file, ("ArrowUp", "KeyQ"), keyboard, page.clock)


def test_a_held_key_moves_out_and_a_released_one_back(study: Path) -> None:
    page = Page(study)
    keys = levers(study, page, out_in=0.4, back_in=0.2)
    found = []
    for held in (("ArrowUp",), ("ArrowUp",), ("ArrowUp", "KeyQ"), (), ()):
        page.now += 0.1
        page.hold(*held)
        found.append(keys.read())
    assert [up for up, _ in found] == pytest.approx([0.25, 0.5, 0.75, 0.25, 0.0])
    assert [turn for _, turn in found] == pytest.approx([0.0, 0.0, 0.25, 0.0, 0.0])


def test_keys_that_nobody_renews_are_released(study: Path) -> None:
    page = Page(study)
    keys = levers(study, page, stale_after=0.3, out_in=0.1)
    page.hold("ArrowUp")
    page.now += 0.3
    assert keys.read()[0] == 1.0
    page.now += 0.1
    assert keys.read()[0] < 1.0


def test_a_page_that_begins_later_or_anew_is_found(study: Path) -> None:
    page = Page(study)
    page.file.remove()
    keys = levers(study, page, out_in=0.1)
    assert keys.read()[0] == 0.0
    for _ in range(2):
        page.file = LatestValue(keys_file(study), 4096)
        page.now += 1.0
        page.hold("ArrowUp")
        keys.read()
        page.now += 0.1
        assert keys.read()[0] == 1.0
        page.now += 5.0
        assert keys.read()[0] == 0.0


def test_what_is_not_understood_holds_nothing(study: Path) -> None:
    page = Page(study)
    keys = levers(study, page)
    page.file.write(b'{"at": "noon"}')
    page.now += 0.1
    assert keys.read() == (0.0, 0.0)


def test_arrows_drive_and_two_letter_keys_turn(study: Path) -> None:
    import time

    with LatestValue(keys_file(study), 4096) as file:
        device = Keyboard(out_in=1e-6).at(study).connect(250)
        device.advance(NO_HAND)
        told = {"at": time.monotonic(), "held": ["ArrowUp", "ArrowRight", "KeyQ"]}
        file.write(json.dumps(told).encode())
        assert device.advance(NO_HAND).position == (FULL.x, -FULL.y, FULL.theta)
        assert device.trouble() == ""
        device.close()


def test_outside_a_session_there_are_no_keys() -> None:
    with pytest.raises(NoKeys, match="only a live session has"):
        Keyboard().connect(250).advance(NO_HAND)
