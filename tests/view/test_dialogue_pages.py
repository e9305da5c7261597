"""The pages between trials: everyone can answer them, and the answers come back as values."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest
from view.axe import complaints

from omnistudy.channel import LatestValue
from omnistudy.devices.handheld.keyboard import keys_file
from omnistudy.errors.session import NobodyAnswers, StoppedBetweenTrials
from omnistudy.protocol.compose import compose_protocol
from omnistudy.study import create_study
from omnistudy.survey import (
    Anchor,
    Answer,
    Answers,
    Asked,
    ChoiceItem,
    ConsentAnswer,
    ConsentForm,
    Instrument,
    LikertItem,
    NumberItem,
    Option,
    Scale,
    Section,
    TextItem,
)
from omnistudy.view.attendance import Attendance, attended
from omnistudy.view.chromium import Browser, Tab
from omnistudy.view.page_dialogue import PageDialogue

from .conftest import SHORT
from .people import (
    Person,
    Stick,
    WithFinger,
    WithKeyboard,
    WithMouse,
    WithOneSwitch,
    WithStick,
    press,
    until,
)

PATIENCE_S = 60.0
FORM = ConsentForm(
    title="Driving with a stick",
    version="2",
    language="en",
    sections=(
        Section(heading="What this is about", paragraphs=("You drive a robot.",)),
        Section(heading="Your data", paragraphs=("They are stored under a code.",)),
    ),
    asked=(
        Asked(name="part", text="I take part of my own free will."),
        Asked(name="video", text="I may be filmed.", required=False),
    ),
)
QUALITY = Scale(
    highest=5, anchors=(Anchor(value=1, label="very poor"), Anchor(value=5, label="very good"))
)
INSTRUMENT = Instrument(
    name="drive",
    title="About your drive",
    source="ours",
    language="en",
    introduction="Please rate from 1 (very poor) to 5 (very good).",
    items=(
        LikertItem(name="comfort", question="How comfortable was it?", scale=QUALITY),
        ChoiceItem(
            name="hand",
            question="Which hand did you use?",
            options=(Option(name="left", text="The left"), Option(name="right", text="The right")),
        ),
        NumberItem(name="age", question="How old are you?", unit="years", whole=True, lowest=18),
        TextItem(name="comments", question="Comments", required=False),
    ),
)
ANSWERED = Answers(
    instrument="drive",
    given=(
        Answer(item="comfort", value=4),
        Answer(item="hand", value="right"),
        Answer(item="age", value=44),
        Answer(item="comments", value="hi"),
    ),
)
MAIN = ".sheet .main"
STEP = "document.querySelector('.step')?.textContent"


class Meeting:
    """A session that speaks through the page in a tab, from a thread of its own."""

    def __init__(self, study: Path, attendance: Attendance, tab: Tab, pool: ThreadPoolExecutor):
        self.study = study
        self.tab = tab
        self.stick = Stick()
        self._attendance = attendance
        self._pool = pool
        self.address = attendance.address.replace("/?", "/participant?")

    def dialogue(self, with_stick: bool = False, patience_s: float = PATIENCE_S) -> PageDialogue:
        stick = self.stick if with_stick else None
        return self._attendance.converse(patience_s=patience_s, stick=stick)

    def begin(self, said: Callable[..., Any], *given: Any) -> Future[Any]:
        """Let the session say something, and wait until it is on the page."""
        before = self.tab.value("window.participant.asked?.mark ?? ''")
        begun = self._pool.submit(said, *given)
        self.tab.wait_for(
            f"(window.participant.asked?.mark ?? {before!r}) !== {before!r}"
            "&& document.querySelector('.sheet') !== null",
            20,
        )
        return begun


@contextmanager
def meeting(browser: Browser, folder: Path, *overrides: str) -> Iterator[Meeting]:
    study = folder / "met.db"
    create_study(compose_protocol("utah2017_component", (*SHORT, *overrides)), study, "met")
    with ExitStack() as stack:
        pool = stack.enter_context(ThreadPoolExecutor(1))
        attendance = stack.enter_context(attended(study))
        tab = browser.tab(800, 600)
        met = Meeting(study, attendance, tab, pool)
        tab.open(met.address)
        tab.wait_for("window.participant !== undefined")
        yield met
        assert tab.faults == []


@pytest.fixture(scope="module")
def met(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Meeting]:
    with meeting(chromium, tmp_path_factory.mktemp("met")) as met:
        yield met


@pytest.fixture(scope="module")
def met_switch(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Meeting]:
    scanning = ("site.scanning.one_switch=true", "site.scanning.pace=0.3")
    with meeting(chromium, tmp_path_factory.mktemp("switch"), *scanning) as met:
        yield met


@pytest.fixture(params=[WithMouse, WithFinger, WithKeyboard, WithOneSwitch, WithStick])
def person(request: pytest.FixtureRequest) -> Iterator[tuple[Person, Meeting, PageDialogue]]:
    chosen = request.param
    met = request.getfixturevalue("met_switch" if chosen is WithOneSwitch else "met")
    if chosen is WithStick:
        yield WithStick(met.tab, met.stick), met, met.dialogue(with_stick=True)
    else:
        yield chosen(met.tab), met, met.dialogue()


Met = tuple[Person, Meeting, PageDialogue]


def test_everyone_gets_from_instructions_to_the_countdown(person: Met) -> None:
    who, met, dialogue = person
    read = met.begin(dialogue.instruct)
    assert "You drive a robot" in met.tab.value("document.querySelector('.sheet').textContent")
    who.take(MAIN)
    read.result(20)
    rested = met.begin(dialogue.rest, 75.0)
    met.tab.wait_for("document.querySelector('[role=timer]')?.textContent.includes('1:1')")
    who.take(MAIN)
    rested.result(20)


def test_everyone_can_agree_and_decline(person: Met) -> None:
    who, met, dialogue = person
    said = met.begin(dialogue.consent, FORM)
    who.take(MAIN)
    who.take(MAIN)
    met.tab.wait_for("document.querySelector('.fault').textContent.includes('everything that is')")
    assert not said.done()
    who.take("input[type=checkbox]")
    who.take(MAIN)
    assert said.result(20) == ConsentAnswer(version="2", agreed=True, ticked=("part",))
    said = met.begin(dialogue.consent, FORM)
    who.take(MAIN)
    who.take(".foot :nth-last-child(2)")
    assert said.result(20) == ConsentAnswer(version="2", agreed=False)


@pytest.mark.slow
def test_everyone_can_answer_every_kind_of_question(person: Met) -> None:
    who, met, dialogue = person
    asked = met.begin(dialogue.ask, INSTRUMENT)
    who.take("input[type=radio][value='4']")
    who.take(MAIN)
    who.take("input[type=radio][value=right]")
    who.take(MAIN)
    who.write("44")
    who.take(MAIN)
    who.write("hi")
    who.take(MAIN)
    assert asked.result(20) == ANSWERED


def test_everyone_can_stop(person: Met) -> None:
    who, met, dialogue = person
    rested = met.begin(dialogue.rest, 30.0)
    who.take(".stop")
    with pytest.raises(StoppedBetweenTrials, match="stop was pressed on the rest page"):
        rested.result(20)
    assert met.tab.value("document.querySelector('.message').textContent").startswith("Stopped")


def test_a_stick_that_is_held_takes_the_choice(met: Meeting) -> None:
    read = met.begin(met.dialogue(with_stick=True).instruct)
    who = WithStick(met.tab, met.stick)
    who.let_go()
    who.move((-0.9, 0.0, 0.0))
    met.tab.wait_for("document.querySelector('.lit') !== null")
    read.result(20)


def test_a_stick_that_was_pushed_before_must_come_back_first(met: Meeting) -> None:
    dialogue = met.dialogue(with_stick=True)
    who = WithStick(met.tab, met.stick)
    read = met.begin(dialogue.instruct)
    who.take(MAIN)
    read.result(20)
    met.tab.value("window.participant.stick.ready = true")  # as after a page that it did not end
    met.stick.push = (-0.9, 0.0, 0.0)
    read = met.begin(dialogue.instruct)
    met.tab.wait_for("window.participant.live.dialogue?.stick?.[0] === -0.9")
    assert not met.tab.value("window.participant.stick.ready")
    assert met.tab.value("document.querySelector('.lit')") is None
    who.take(MAIN)
    read.result(20)


def test_answers_are_held_against_the_question(met: Meeting) -> None:
    who = WithKeyboard(met.tab)
    asked = met.begin(met.dialogue().ask, INSTRUMENT.model_copy(update={"items": AGE_AND_WORDS}))
    fault = "document.querySelector('.fault').textContent"
    for written, told in (
        ("", "Please answer this question."),
        ("old", "Please give a number."),
        ("4,5", "Please give a whole number."),
        ("17", "Please give 18 or more."),
    ):
        met.tab.value("document.querySelector('.field input').value = ''")
        who.write(written)
        met.tab.value("document.querySelector('.field input').dispatchEvent(new Event('input'))")
        who.take(MAIN)
        met.tab.wait_for(f"{fault} === {told!r}")
    met.tab.value("document.querySelector('.field input').value = ''")
    who.write("18")
    who.take(MAIN)
    who.take(MAIN)
    given = asked.result(20).given
    assert [answer.value for answer in given] == [18, None]


AGE_AND_WORDS = INSTRUMENT.items[2:]


def test_a_page_that_is_loaded_again_has_the_answers_still(met: Meeting) -> None:
    who = WithMouse(met.tab)
    asked = met.begin(met.dialogue().ask, INSTRUMENT)
    who.take("input[value='4']")
    who.take(MAIN)
    who.take("input[value=right]")
    met.tab.ask("Page.reload")
    met.tab.wait_for(f"window.participant && {STEP} === 'Question 2 of 4'")
    assert met.tab.value("document.querySelector(':checked').value") == "right"
    who.take(".foot button:not([hidden])")
    met.tab.wait_for(f"{STEP} === 'Question 1 of 4'")
    assert met.tab.value("document.querySelector(':checked').value") == "4"
    who.take(MAIN)
    who.take(MAIN)
    who.write("44")
    who.take(MAIN)
    who.write("hi")
    who.take(MAIN)
    assert asked.result(20) == ANSWERED
    assert met.tab.value("sessionStorage.length") == 0


@pytest.mark.slow
def test_the_countdown_counts_and_the_thanks_stay(met: Meeting) -> None:
    met.tab.value(
        "window.counts = []; new MutationObserver(() => {"
        "const n = document.querySelector('.count')?.textContent;"
        "if (n && window.counts.at(-1) !== n) window.counts.push(n)})"
        ".observe(document.body, {subtree: true, childList: true, characterData: true})"
    )
    met.begin(met.dialogue().count_down, 1).result(20)
    assert met.tab.value("window.counts") == ["3", "2", "1"]
    met.tab.wait_for("document.querySelector('.message').textContent === 'The round begins.'")
    met.begin(met.dialogue().thank).result(20)
    met.tab.wait_for("window.participant.live.dialogue === null")
    assert met.tab.value("document.querySelector('.sheet h1').textContent") == "Thank you"
    met.tab.value(
        "Object.defineProperty("
        "window.participant.live, 'lost', {value: true, configurable: true}) && 0"
    )
    met.tab.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    assert met.tab.value("document.querySelector('.message').hidden")
    met.tab.value("delete window.participant.live.lost")


def test_nobody_is_waited_for_for_ever(met: Meeting) -> None:
    rested = met.begin(met.dialogue(patience_s=0.5).rest, 30.0)
    with pytest.raises(NobodyAnswers, match="the rest page waited"):
        rested.result(20)


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


def on(met: Meeting, page: str) -> Future[Any]:
    dialogue = met.dialogue()
    given = {
        "instruct": (dialogue.instruct,),
        "rest": (dialogue.rest, 30.0),
        "consent": (dialogue.consent, FORM),
        "survey": (dialogue.ask, INSTRUMENT),
    }
    return met.begin(*given[page])


@pytest.mark.slow
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
    asked = met.begin(met.dialogue().ask, INSTRUMENT.model_copy(update={"items": AGE_AND_WORDS}))
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
