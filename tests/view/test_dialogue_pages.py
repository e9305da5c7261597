"""The pages between trials: everyone can answer them, and the answers come back as values."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from omnistudy.errors.session import NobodyAnswers, StoppedBetweenTrials
from omnistudy.survey import ConsentAnswer
from omnistudy.view.page_dialogue import PageDialogue

from .meeting import AGE_AND_WORDS, ANSWERED, FORM, INSTRUMENT, MAIN, STEP, Meeting
from .people import (
    Person,
    WithFinger,
    WithKeyboard,
    WithMouse,
    WithOneSwitch,
    WithStick,
)

pytestmark = pytest.mark.slow

Met = tuple[Person, Meeting, PageDialogue]


@pytest.fixture(params=[WithMouse, WithFinger, WithKeyboard, WithOneSwitch, WithStick])
def person(request: pytest.FixtureRequest) -> Iterator[tuple[Person, Meeting, PageDialogue]]:
    chosen = request.param
    met = request.getfixturevalue("met_switch" if chosen is WithOneSwitch else "met")
    if chosen is WithStick:
        yield WithStick(met.tab, met.stick), met, met.dialogue(with_stick=True)
    else:
        yield chosen(met.tab), met, met.dialogue()


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
    asked = met.begin(met.dialogue().ask, AGE_AND_WORDS)
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
