"""What is said round the trials, and what virtual participants answer."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors.session import StoppedBetweenTrials
from omnistudy.protocol.compose import compose_protocol
from omnistudy.seeds import seed_text
from omnistudy.session import run_trials
from omnistudy.session.dialogue import Dialogue
from omnistudy.session.held_devices import HeldDevices
from omnistudy.session.live import RealTime, run_live
from omnistudy.session.pauses import Pauses
from omnistudy.session.virtual_dialogue import VirtualDialogue
from omnistudy.store import StoredTrial, StudyWriter
from omnistudy.study import create_study
from omnistudy.survey import (
    Asked,
    ConsentAnswer,
    ConsentForm,
    Instrument,
    NumberItem,
    Section,
    load_instrument,
)

FORM = ConsentForm(
    title="Form",
    version="3",
    language="en",
    sections=(Section(heading="What", paragraphs=("This.",)),),
    asked=(Asked(name="part", text="I take part."),),
)


class Heard(VirtualDialogue):
    """Notes what is said to a virtual participant."""

    def __init__(self) -> None:
        super().__init__(seed_text("heard"))
        object.__setattr__(self, "said", [])

    said: list[str]

    def instruct(self) -> None:
        self.said.append("instruct")

    def rest(self, seconds: float) -> None:
        self.said.append(f"rest {seconds:g} s")

    def count_down(self, trial: int) -> None:
        self.said.append(f"count down to {trial}")

    def thank(self) -> None:
        self.said.append("thank")


@pytest.fixture
def study(tmp_path: Path) -> Path:
    path = tmp_path / "heard.db"
    short = ("world=primitive_c", "routes=[through]", "participants.count=2")
    create_study(compose_protocol("utah2017_component", short), path, "heard")
    return path


def trials(study: Path) -> list[StoredTrial]:
    with StudyWriter.open(study) as writer:
        return list(writer.trials())


def test_a_visit_begins_with_instructions_rests_between_and_ends_with_thanks(study: Path) -> None:
    first, second, *_ = trials(study)
    other = next(trial for trial in trials(study) if trial.session_id != first.session_id)
    dialogue = Heard()
    led = Pauses(dialogue, 60.0)
    for trial in (first, second, other):
        led.before(trial)
    led.end()
    led.end()
    assert dialogue.said == [
        "instruct",
        f"count down to {first.id}",
        "rest 60 s",
        f"count down to {second.id}",
        "thank",
        "instruct",
        f"count down to {other.id}",
        "thank",
    ]


def test_who_stops_between_trials_leaves_the_next_one_planned(study: Path) -> None:
    def before(trial: StoredTrial) -> None:
        raise StoppedBetweenTrials("rest")

    def nobody(trial: StoredTrial) -> RealTime:
        raise AssertionError("the trial must not begin")

    devices = HeldDevices(study)
    with pytest.raises(StoppedBetweenTrials, match="what was driven is kept"):
        run_trials(study, run=lambda ready, specs: run_live(ready, specs, nobody, devices, before))
    assert {trial.status for trial in trials(study)} == {"planned"}


def test_a_virtual_participant_answers_at_once_and_always_the_same() -> None:
    dialogue: Dialogue = VirtualDialogue(seed_text("P01"))
    survey = load_instrument("utah2017")
    answers = dialogue.ask(survey)
    assert [answer.item for answer in answers.given] == [item.name for item in survey.items]
    assert answers == VirtualDialogue(seed_text("P01")).ask(survey)
    assert answers != VirtualDialogue(seed_text("P02")).ask(survey)
    agreed = ConsentAnswer(version="3", agreed=True, ticked=("part",))
    assert dialogue.consent(FORM) == agreed


@given(
    seed=st.text("0123456789abcdef", min_size=1, max_size=8),
    lowest=st.none() | st.integers(-50, 50),
    width=st.none() | st.integers(1, 30),
    whole=st.booleans(),
)
def test_a_number_that_is_drawn_lies_within_its_bounds(
    seed: str, lowest: int | None, width: int | None, whole: bool
) -> None:
    highest = None if width is None else (lowest or 0) + width
    item = NumberItem(name="n", question="?", lowest=lowest, highest=highest, whole=whole)
    asked = Instrument(name="n", title="n", source="ours", language="en", items=(item,))
    (answer,) = VirtualDialogue(seed).ask(asked).given
    assert isinstance(answer.value, int if whole else float)


def test_sessions_of_one_participant_are_told_apart_by_their_visit(study: Path) -> None:
    first = trials(study)[0]
    dialogue = Heard()
    led = Pauses(dialogue, 60.0)
    led.before(first)
    led.before(replace(first, session_id=first.session_id + 1))
    assert [said for said in dialogue.said if "count" not in said] == [
        "instruct",
        "thank",
        "instruct",
    ]
