"""Answers are values that fit their questions, or are refused."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from omnistudy.errors.survey import AnswersDoNotFit
from omnistudy.survey import (
    Anchor,
    Answer,
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
from omnistudy.survey.answers import LONGEST_TEXT, checked

SCALE = Scale(highest=5, anchors=(Anchor(value=1, label="poor"), Anchor(value=5, label="good")))
HANDS = (Option(name="left", text="The left"), Option(name="right", text="The right"))
INSTRUMENT = Instrument(
    name="drive",
    title="About your drive",
    source="ours",
    language="en",
    items=(
        LikertItem(name="comfort", question="How comfortable?", scale=SCALE),
        ChoiceItem(name="hand", question="Which hand?", options=HANDS),
        NumberItem(name="age", question="How old?", whole=True, lowest=18, highest=99),
        TextItem(name="comments", question="Comments", required=False),
    ),
)
RIGHT = {"comfort": 4, "hand": "left", "age": 44}


def given(**changed: object) -> list[Answer]:
    values = {**RIGHT, **changed}
    return [Answer.model_validate({"item": name, "value": values[name]}) for name in values]


def test_answers_stand_in_the_instruments_order_and_none_is_left_out() -> None:
    answers = checked(INSTRUMENT, reversed(given()))
    assert answers.instrument == "drive"
    assert [(one.item, one.value) for one in answers.given] == [
        ("comfort", 4),
        ("hand", "left"),
        ("age", 44),
        ("comments", None),
    ]


@pytest.mark.parametrize(
    ("changed", "told"),
    [
        ({"comfort": 6}, "'comfort': given 6, but the answers are 1 poor, 2, 3, 4, 5 good"),
        ({"comfort": 2.5}, "'comfort': given 2.5"),
        ({"comfort": "4"}, "'comfort': given '4'"),
        ({"comfort": None}, "'comfort': needs an answer"),
        ({"hand": "both"}, "'hand': given 'both', but the answers are The left / The right"),
        ({"age": 17}, "'age': given 17, but the answers are a whole number from 18 to 99"),
        ({"age": 100}, "'age': given 100"),
        ({"age": 44.5}, "'age': given 44.5"),
        ({"age": float("nan")}, "'age': given nan"),
        ({"age": "old"}, "'age': given 'old'"),
        ({"comments": ""}, "'comments': given ''"),
        ({"comments": "x" * (LONGEST_TEXT + 1)}, "'comments': given 'xxx"),
        ({"weight": 80}, "'weight' is no item"),
    ],
)
def test_what_does_not_fit_is_said(changed: dict[str, object], told: str) -> None:
    with pytest.raises(AnswersDoNotFit) as caught:
        checked(INSTRUMENT, given(**changed))
    (fault,) = caught.value.faults
    assert fault.startswith(told)


def test_every_fault_is_told_at_once() -> None:
    with pytest.raises(AnswersDoNotFit, match="survey 'drive'") as caught:
        checked(INSTRUMENT, ())
    assert len(caught.value.faults) == 3


def test_a_consent_form_asks_nothing_twice() -> None:
    twice = (Asked(name="film", text="I may be filmed."), Asked(name="film", text="Again."))
    with pytest.raises(ValidationError, match="'film' is asked twice"):
        ConsentForm(
            title="Form",
            version="1",
            language="en",
            sections=(Section(heading="What", paragraphs=("This.",)),),
            asked=twice,
        )
