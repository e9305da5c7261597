"""Questions, by what an answer can be."""

from __future__ import annotations

import pytest
from pydantic import TypeAdapter, ValidationError

from omnistudy.survey import (
    Anchor,
    ChoiceItem,
    Item,
    LikertItem,
    NumberItem,
    Option,
    Scale,
    TextItem,
)

ITEM: TypeAdapter[Item] = TypeAdapter(Item)
QUALITY = Scale(
    highest=5, anchors=(Anchor(value=1, label="poor"), Anchor(value=5, label="very good"))
)


def test_kind_tells_which_question_it_is() -> None:
    item = ITEM.validate_python({"kind": "number", "name": "age", "question": "How old are you?"})
    assert isinstance(item, NumberItem)
    assert item.required
    assert item.conditions == ()


@pytest.mark.parametrize(
    ("item", "answers"),
    [
        (LikertItem(name="a", question="?", scale=QUALITY), "1 poor, 2, 3, 4, 5 very good"),
        (
            ChoiceItem(
                name="a",
                question="?",
                options=(Option(name="l", text="The left"), Option(name="r", text="The right")),
            ),
            "The left / The right",
        ),
        (NumberItem(name="a", question="?"), "a number"),
        (
            NumberItem(name="a", question="?", whole=True, lowest=18, highest=99.5, unit="years"),
            "a whole number from 18 to 99.5 years",
        ),
        (TextItem(name="a", question="?"), "words"),
    ],
)
def test_answers_are_said_in_words(item: Item, answers: str) -> None:
    assert item.answers == answers


def test_options_must_differ() -> None:
    twice = (Option(name="l", text="The left"), Option(name="l", text="The other"))
    with pytest.raises(ValidationError, match="two options have the name 'l'"):
        ChoiceItem(name="hand", question="Which hand?", options=twice)


def test_a_choice_needs_two_options() -> None:
    with pytest.raises(ValidationError, match="at least 2"):
        ChoiceItem(name="hand", question="Which hand?", options=(Option(name="l", text="L"),))


@pytest.mark.parametrize(("lowest", "highest"), [(2.0, 1.0), (1.0, 1.0)])
def test_bounds_must_leave_room(lowest: float, highest: float) -> None:
    with pytest.raises(ValidationError, match="must be below highest"):
        NumberItem(name="age", question="How old?", lowest=lowest, highest=highest)


def test_a_name_is_one_that_tables_can_have() -> None:
    with pytest.raises(ValidationError, match="pattern"):
        TextItem(name="Any comments", question="?")
