"""A dialogue by page as the session sees it, without a browser."""

from __future__ import annotations

import json
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from omnistudy.channel import LatestValue
from omnistudy.errors.survey import AnswersDoNotFit
from omnistudy.survey import Asked, ConsentForm, Section, load_instrument
from omnistudy.view.answer import Answer, Said
from omnistudy.view.held_keys import HELD_S, HeldKeys
from omnistudy.view.live_files import CAPACITY
from omnistudy.view.page_dialogue import PageDialogue

from .people import until

FORM = ConsentForm(
    title="Form",
    version="1",
    language="en",
    sections=(Section(heading="What", paragraphs=("This.",)),),
    asked=(Asked(name="part", text="I take part."), Asked(name="film", text="Film me.")),
)


class Files:
    """The two files that session and server share, with the server's side by hand."""

    def __init__(self, folder: Path) -> None:
        self.state = LatestValue(folder / "state", CAPACITY)
        self.answer = LatestValue(folder / "answer", CAPACITY)

    def __call__(self) -> tuple[LatestValue, LatestValue]:
        return self.state, self.answer

    def shown(self) -> dict[str, object] | None:
        found = self.state.read()
        return json.loads(found.data).get("dialogue") if found else None

    def say(self, **said: object) -> None:
        until(lambda: self.shown() is not None)
        shown = self.shown()
        assert shown is not None
        answer = Answer(said=Said.model_validate({"to": shown["mark"], **said}))
        self.answer.write(answer.model_dump_json().encode())


@pytest.fixture
def files(tmp_path: Path) -> Files:
    return Files(tmp_path)


@pytest.fixture
def pool() -> Iterator[ThreadPoolExecutor]:
    with ThreadPoolExecutor(1) as made:
        yield made


def test_who_agrees_without_what_is_needed_has_not_agreed(
    files: Files, pool: ThreadPoolExecutor
) -> None:
    said = pool.submit(PageDialogue(files, patience_s=20.0).consent, FORM)
    files.say(agreed=True, ticked=("part", "soul"))
    answer = said.result(20)
    assert (answer.agreed, answer.ticked) == (False, ("part",))


def test_answers_that_do_not_fit_are_refused_whoever_sent_them(
    files: Files, pool: ThreadPoolExecutor
) -> None:
    said = pool.submit(PageDialogue(files, patience_s=20.0).ask, load_instrument("utah2017"))
    files.say(given=({"item": "video_games", "value": 9},))
    with pytest.raises(AnswersDoNotFit, match="'video_games': given 9"):
        said.result(20)


def test_an_answer_to_an_earlier_page_does_not_count(
    files: Files, pool: ThreadPoolExecutor
) -> None:
    files.answer.write(Answer(said=Said(to="another")).model_dump_json().encode())
    dialogue = PageDialogue(files, patience_s=20.0)
    rested = pool.submit(dialogue.rest, 9.0)
    until(lambda: files.shown() is not None)
    assert not rested.done()
    files.say()
    rested.result(20)


def test_what_ends_by_itself_needs_nobody(files: Files) -> None:
    dialogue = PageDialogue(files, automatic_s=0.05, patience_s=20.0)
    dialogue.instruct()
    dialogue.rest(60.0)


def test_what_stood_there_when_the_trial_ended_is_shown_again(
    files: Files, pool: ThreadPoolExecutor
) -> None:
    files.state.write(json.dumps({"trial": 1, "lines": ["Game Over"]}).encode())
    rested = pool.submit(PageDialogue(files, patience_s=20.0).rest, 9.0)
    until(lambda: files.shown() is not None)
    assert (files.shown() or {})["lines"] == ["Game Over"]
    files.say()
    rested.result(20)


def test_keys_of_two_pages_add_up_and_a_silent_page_lets_go(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    now = 100.0
    monkeypatch.setattr("omnistudy.view.held_keys.time.monotonic", lambda: now)
    keys = HeldKeys()
    keys.hold(1, ("KeyW",))
    assert json.loads(keys.hold(2, ("ArrowLeft",))) == {"at": 100.0, "held": ["ArrowLeft", "KeyW"]}
    now = 100.0 + HELD_S + 0.01
    assert json.loads(keys.hold(2, ("ArrowLeft",)))["held"] == ["ArrowLeft"]
    assert json.loads(keys.hold(2, ()))["held"] == []
