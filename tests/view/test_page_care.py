"""The pages between trials leave nobody behind: focus, contrast, small screens, lost lines."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from view.axe import complaints

from omnistudy.channel import LatestValue
from omnistudy.devices.handheld.keyboard import keys_file
from omnistudy.errors.session import StoppedBetweenTrials
from omnistudy.view.chromium import Browser

from .meeting import AGE_AND_WORDS, MAIN, Meeting, meeting, on
from .people import WithKeyboard, WithMouse, press, until

pytestmark = pytest.mark.slow

CONTROLS = "button:enabled, input, textarea, [tabindex='0']"
VISIBLE = f"""
[...document.querySelectorAll({CONTROLS!r})].filter((one) => one.getClientRects().length)
"""
OUTLINED = """
(() => {
  const one = document.activeElement;
  const shown = one.closest('.tile') ?? one;
  const {outlineStyle, outlineWidth} = getComputedStyle(shown);
  return one === document.body || (outlineStyle === 'solid' && parseFloat(outlineWidth) >= 3);
})()
"""


@pytest.mark.parametrize("page", ["instruct", "rest", "consent", "survey"])
def test_tab_goes_through_every_control_and_the_focus_is_seen(met: Meeting, page: str) -> None:
    begun = on(met, page)
    if page == "consent":
        WithKeyboard(met.tab).take(MAIN)
    met.tab.value(f"{VISIBLE}.forEach((one, i) => one.dataset.at = one.name || `${{i}}`)")
    expected = set(met.tab.value(f"{VISIBLE}.map((one) => one.dataset.at)"))
    reached = set()
    for _ in range(3 * len(expected)):
        press(met.tab, "Tab")
        reached.add(met.tab.value("document.activeElement.dataset.at ?? ''"))
        assert met.tab.value(OUTLINED), met.tab.value("document.activeElement.outerHTML")
    assert reached - {""} == expected
    WithKeyboard(met.tab).take(".stop")
    with pytest.raises(StoppedBetweenTrials):
        begun.result(20)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_between_trials(
    met: Meeting, met_switch: Meeting, front: Path, scheme: str
) -> None:
    for room in (met, met_switch):
        room.tab.ask(
            "Emulation.setEmulatedMedia",
            features=[{"name": "prefers-color-scheme", "value": scheme}],
        )
        for page in ("instruct", "rest", "consent", "survey"):
            begun = on(room, page)
            for _ in range({"consent": 2, "survey": 4}.get(page, 1)):
                assert complaints(room.tab, front) == [], page
                room.tab.value("document.querySelector('.sheet input:not([type=text])')?.click()")
                room.tab.value(
                    "(() => {const f = document.querySelector('.field input');"
                    "if (f) {f.value = '44'; f.dispatchEvent(new Event('input'))}})()"
                )
                room.tab.value(f"document.querySelector({MAIN!r}).click()")
            begun.result(20)
        begun = room.begin(room.dialogue().count_down, 1)
        assert complaints(room.tab, front) == []
        begun.result(20)
        begun = room.begin(room.dialogue().thank)
        assert complaints(room.tab, front) == []
        begun.result(20)


def test_held_keys_are_told_and_let_go(met: Meeting) -> None:
    met.begin(met.dialogue().count_down, 1).result(20)
    with LatestValue(keys_file(met.study)) as keys:

        def held() -> list[str] | None:
            found = keys.read()
            return json.loads(found.data)["held"] if found else None

        def at() -> float:
            found = keys.read()
            assert found is not None
            return float(json.loads(found.data)["at"])

        for code in ("KeyW", "ArrowLeft"):
            met.tab.ask("Input.dispatchKeyEvent", type="rawKeyDown", key="w", code=code)
        until(lambda: held() == ["ArrowLeft", "KeyW"])
        before = at()
        until(lambda: at() > before)
        met.tab.ask("Input.dispatchKeyEvent", type="keyUp", key="w", code="KeyW")
        until(lambda: held() == ["ArrowLeft"])
        met.tab.value("dispatchEvent(new Event('blur'))")
        until(lambda: held() == [])


def test_what_is_written_is_nobodys_business(met: Meeting) -> None:
    asked = met.begin(met.dialogue().ask, AGE_AND_WORDS)
    met.tab.value(
        "window.told = []; window.participant.live.say = (() => {"
        "const say = window.participant.live.say.bind(window.participant.live);"
        "return (what) => {if (what.keys) window.told.push(...what.keys); say(what)}})()"
    )
    who = WithKeyboard(met.tab)
    who.write("44")
    press(met.tab, "x")
    assert met.tab.value("window.told") == []
    who.take(".stop")
    with pytest.raises(StoppedBetweenTrials):
        asked.result(20)


AWAKE = """
window.asked = 0;
Object.defineProperty(navigator, 'wakeLock', {
  value: {request: () => {window.asked += 1; return Promise.resolve({})}},
});
"""


def test_the_screen_is_kept_awake_again_when_it_comes_back(chromium: Browser, met: Meeting) -> None:
    tab = chromium.tab()
    tab.ask("Page.addScriptToEvaluateOnNewDocument", source=AWAKE)
    tab.open(met.address)
    tab.wait_for("window.asked === 1")
    tab.value("document.dispatchEvent(new Event('visibilitychange'))")
    tab.wait_for("window.asked === 2")
    tab.open("about:blank#gone")


def test_being_ready_fills_the_screen(chromium: Browser, met: Meeting) -> None:
    read = met.begin(met.dialogue().instruct)
    met.tab.value("document.fullscreenElement && void document.exitFullscreen()")
    met.tab.wait_for("document.fullscreenElement === null")
    met.tab.value(
        "Element.prototype.requestFullscreen = () => {window.filled = true; "
        "return Promise.resolve()}"
    )
    WithMouse(met.tab).take(MAIN)
    read.result(20)
    assert met.tab.value("window.filled")


def test_without_webgl_it_is_said_and_stop_stays(chromium: Browser, met: Meeting) -> None:
    tab = chromium.tab(800, 600)
    tab.ask(
        "Page.addScriptToEvaluateOnNewDocument",
        source="HTMLCanvasElement.prototype.getContext = () => null",
    )
    tab.open(met.address)
    tab.wait_for("window.participant !== undefined")
    met.begin(met.dialogue().count_down, 1).result(20)
    tab.wait_for("document.querySelector('.message').textContent.startsWith('This screen cannot')")
    assert tab.value("document.querySelector('.stop').getClientRects().length") == 1
    assert tab.faults == []
    tab.open("about:blank#gone")


HIDDEN = """
(() => {
  const shown = '.foot button:not([hidden]), .stop, .whole:not([hidden])';
  const buttons = [...document.querySelectorAll(shown)];
  const places = buttons.map((one) => [one.textContent, one.getBoundingClientRect()]);
  const cut = places.filter(([, r]) => r.left < 0 || r.top < 0
    || r.right > innerWidth || r.bottom > innerHeight);
  const over = places.flatMap(([name, a], i) => places.slice(i + 1)
    .filter(([, b]) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
    .map(([other]) => `${name} over ${other}`));
  const wide = document.documentElement.scrollWidth > innerWidth ? ['too wide'] : [];
  return [...cut.map(([name]) => `${name} is cut off`), ...over, ...wide];
})()
"""


@pytest.mark.parametrize("size", [(800, 600), (667, 375), (1920, 1080)])
@pytest.mark.parametrize("page", ["instruct", "rest", "consent", "survey"])
def test_nothing_is_cut_off_on_small_screens(
    met: Meeting, page: str, size: tuple[int, int]
) -> None:
    met.tab.resize(*size)
    begun = on(met, page)
    if page == "consent":
        WithMouse(met.tab).take(MAIN)
    assert met.tab.value(HIDDEN) == []
    WithMouse(met.tab).take(".stop")
    with pytest.raises(StoppedBetweenTrials):
        begun.result(20)
    met.tab.resize(800, 600)


def test_a_lost_connection_is_told(chromium: Browser, tmp_path: Path) -> None:
    with meeting(chromium, tmp_path) as met:
        met.begin(met.dialogue().count_down, 1).result(20)
        tab = met.tab
    told = "document.querySelector('.message').textContent"
    tab.wait_for(f"{told}.includes('connection was lost')")
    assert not tab.value("document.querySelector('.message').hidden")


def test_the_monitor_says_what_the_participant_is_shown(chromium: Browser, met: Meeting) -> None:
    watch = chromium.tab(800, 600)
    watch.open(met.address.replace("/participant?", "/monitor?"))
    watch.wait_for("document.querySelector('.where').textContent === 'No trial is running.'")
    rest = met.begin(met.dialogue().rest, 50.0)
    watch.wait_for("document.querySelector('.where').textContent === 'The participant rests.'")
    assert re.fullmatch(
        r"pause, 0:[1-5]\d\.\d left",
        watch.value("document.querySelector('.numbers dd').textContent"),
    )
    WithMouse(met.tab).take(MAIN)
    rest.result(20)
    watch.wait_for("document.querySelector('.numbers dd').textContent === '–'")
    assert watch.faults == []
