"""The replay page in a real browser, opened from disk."""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Callable, Iterator
from io import BytesIO
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import omnistudy
from omnistudy.errors.view import NoFolderForPage, PageExists
from omnistudy.view.chromium import FLAGS, Browser, Tab, browser
from omnistudy.view.film import Film, film
from omnistudy.view.page import replay_page, write_page

AT = "window.replay.player.t"
PLAYED = """(() => {
  const due = [];
  const real = window.requestAnimationFrame;
  window.requestAnimationFrame = (draw) => due.push(draw);
  const {player} = window.replay;
  player.speed = 8;
  player.seek(0);
  player.start();
  let [now, most, frames] = [performance.now(), 0, 0];
  for (; due.length; frames += 1) {
    const before = player.t;
    now += 500;
    for (const draw of due.splice(0)) draw(now);
    most = Math.max(most, before);
  }
  window.requestAnimationFrame = real;
  return [player.t, most, frames];
})()"""
"""Plays at 8x and two frames a second: where that ended and was before, and how many frames."""


@pytest.fixture(scope="module")
def films(driven_study: Path) -> tuple[Film, ...]:
    with omnistudy.open(driven_study) as study:
        return film(study, 1), film(study, 2)


@pytest.fixture(scope="module")
def page(films: tuple[Film, ...], tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("pages") / "trial.html"
    write_page(replay_page(films[:1]), file)
    return file


@pytest.fixture
def tab(chromium: Browser, page: Path) -> Iterator[Tab]:
    tab = chromium.tab(900, 700)
    tab.open(page.as_uri())
    tab.wait_for("window.replay !== undefined")
    yield tab
    assert tab.faults == []


def pixels(tab: Tab) -> NDArray[np.float64]:
    with Image.open(BytesIO(tab.picture())) as picture:
        return np.asarray(picture.convert("RGB"), dtype=np.float64)


def press(tab: Tab, key: str) -> None:
    for kind in ("keyDown", "keyUp"):
        tab.ask("Input.dispatchKeyEvent", type=kind, key=key, text=key if kind == "keyDown" else "")


def test_page_is_small_and_asks_for_nothing_from_outside(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert page.stat().st_size < 4_000_000
    assert "<link" not in text
    assert "<script src" not in text
    assert text.count("</script>") == 2, "what is shown cannot end the script that holds it"


def test_scrubbing_moves_the_robot(tab: Tab) -> None:
    before = pixels(tab)
    tab.value(
        "(() => { const scrub = document.querySelector('input[type=range]');"
        " scrub.value = 8; scrub.dispatchEvent(new Event('input')); })()"
    )
    after = pixels(tab)
    assert tab.value(AT) == 8
    assert tab.value("document.querySelector('.row .time').textContent").startswith("0:08.0")
    assert (np.abs(after - before).max(axis=2) > 30).mean() > 0.02


def test_messages_and_collisions_are_those_of_the_time(tab: Tab, films: tuple[Film, ...]) -> None:
    hit = next(event for event in films[0].events if event.kind == "collision")
    shown = "document.querySelector('.message').innerText"
    count = "document.querySelector('.collisions').textContent"
    tab.value(f"window.replay.seek({hit.t - 0.01})")
    assert tab.value(count) == "0 collisions"
    assert tab.value("document.querySelector('.message').hidden")
    tab.value(f"window.replay.seek({hit.t + 0.01})")
    assert tab.value(count) == "1 collision"
    assert tab.value(shown) == "Drive away from wall 1"


def test_every_camera_sees_something_else(tab: Tab) -> None:
    tab.value("window.replay.seek(5)")
    seen = []
    for key in "123":
        press(tab, key)
        seen.append(pixels(tab))
    assert [np.abs(a - b).mean() > 3 for a, b in pairwise(seen)] == [True, True]


def test_it_plays_and_stops_at_the_end(tab: Tab) -> None:
    end = tab.value("window.replay.end")
    tab.value(f"window.replay.seek({end - 0.3})")
    press(tab, " ")
    assert tab.value("window.replay.player.playing")
    tab.wait_for("!window.replay.player.playing")
    assert tab.value(AT) == pytest.approx(end)


def test_keys_go_to_events_and_single_samples(tab: Tab, films: tuple[Film, ...]) -> None:
    times = [event.t for event in films[0].events if not event.kind.startswith("message")]
    press(tab, "]")
    assert tab.value(AT) == pytest.approx(times[0])
    press(tab, "]")
    assert tab.value(AT) == pytest.approx(times[1])
    press(tab, ".")
    assert tab.value(AT) == pytest.approx(times[1] + 0.05)


def test_two_trials_stay_in_step(
    chromium: Browser, films: tuple[Film, ...], tmp_path: Path
) -> None:
    file = tmp_path / "two.html"
    write_page(replay_page(films), file)
    tab = chromium.tab(1200, 700)
    tab.open(f"{file.as_uri()}#t=4&camera=plan")
    tab.wait_for("window.replay !== undefined")
    assert tab.value("document.querySelectorAll('.scene').length") == 2
    assert tab.value(AT) == 4
    assert tab.value("document.querySelector('input[value=plan]').checked")
    assert tab.faults == []


@pytest.mark.slow
def test_ten_minutes_are_scrubbed_from_end_to_end(
    chromium: Browser, films: tuple[Film, ...], tmp_path: Path
) -> None:
    times = np.arange(12_001) / 20
    file = tmp_path / "long.html"
    write_page(replay_page([lengthened(films[0], times)]), file)
    assert file.stat().st_size < 4_000_000
    tab = chromium.tab(900, 700)
    tab.open(file.as_uri())
    tab.wait_for("window.replay !== undefined")
    for t in (600, 0, 301.5):
        tab.value(f"window.replay.seek({t})")
        assert tab.value(AT) == t
    assert tab.value(PLAYED) == pytest.approx([600, 596, 150], abs=4)
    assert not tab.value("window.replay.player.playing")
    assert tab.faults == []


def lengthened(short: Film, times: NDArray[np.float64]) -> Film:
    """Give a film that goes on and on: SYNTHETIC, its series are repeated."""
    series = []
    for one in short.series:
        values = np.frombuffer(b64decode(one.data), dtype="<f4")
        longer = times if one.name == "t" else np.resize(values, len(times))
        data = b64encode(longer.astype("<f4").tobytes()).decode()
        series.append(one.model_copy(update={"data": data}))
    return short.model_copy(update={"series": tuple(series), "end": float(times[-1])})


def test_without_webgl_the_page_says_what_to_do(
    page: Path, requires_program: Callable[[str, str], str]
) -> None:
    requires_program("chromium", "chromium")
    plain = tuple(flag for flag in FLAGS if "angle" not in flag and "swiftshader" not in flag)
    with browser((*plain, "--disable-gpu", "--disable-3d-apis")) as running:
        tab = running.tab()
        tab.open(page.as_uri())
        tab.wait_for("document.querySelector('h1') !== null")
        assert "no WebGL" in tab.value("document.querySelector('h1').textContent")
        assert "hardware acceleration" in tab.value("document.querySelector('main').innerText")


def test_no_other_file_is_replaced(tmp_path: Path, page: Path) -> None:
    other = tmp_path / "thesis.html"
    other.write_text("mine", encoding="utf-8")
    with pytest.raises(PageExists):
        write_page("new", other)
    assert other.read_text(encoding="utf-8") == "mine"
    with pytest.raises(NoFolderForPage):
        write_page("new", tmp_path / "nowhere" / "page.html")
    again = page.read_text(encoding="utf-8")
    write_page(again, page)
