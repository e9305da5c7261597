"""A session that speaks through the participant's page, and what it says in tests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

from omnistudy.protocol.compose import compose_protocol
from omnistudy.study import create_study
from omnistudy.survey import (
    Anchor,
    Answer,
    Answers,
    Asked,
    ChoiceItem,
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

from .people import Stick

SHORT = ("world=primitive_c", "routes=[through]", "participants.count=1", "order.block_length=1")
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
AGE_AND_WORDS = INSTRUMENT.model_copy(update={"items": INSTRUMENT.items[2:]})


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


def on(met: Meeting, page: str) -> Future[Any]:
    dialogue = met.dialogue()
    given = {
        "instruct": (dialogue.instruct,),
        "rest": (dialogue.rest, 30.0),
        "consent": (dialogue.consent, FORM),
        "survey": (dialogue.ask, INSTRUMENT),
    }
    return met.begin(*given[page])
