"""What a person answered to an instrument, held against its questions."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite

from omnistudy.errors.survey import AnswersDoNotFit
from omnistudy.registry import Model
from omnistudy.registry.name import Name
from omnistudy.survey.instrument import Instrument
from omnistudy.survey.item import ChoiceItem, Item, LikertItem, NumberItem

LONGEST_TEXT = 2000
"""Characters of an answer in words."""


class Answer(Model):
    """The answer to one item; None where an item that may stay unanswered has none.

    value : a point of the scale, a number, the name of an option, or words.
    """

    item: Name
    value: int | float | str | None


class Answers(Model):
    """All of an instrument, in the order of its items."""

    instrument: Name
    given: tuple[Answer, ...]


def checked(instrument: Instrument, given: Iterable[Answer]) -> Answers:
    """Give answers in the instrument's order; raises AnswersDoNotFit with every fault."""
    values = {answer.item: answer.value for answer in given}
    names = [item.name for item in instrument.items]
    faults = [f"'{name}' is no item" for name in values if name not in names]
    answers = []
    for item in instrument.items:
        value = values.get(item.name)
        fault = _fault(item, value)
        if fault:
            faults.append(f"'{item.name}': {fault}")
        answers.append(Answer(item=item.name, value=value))
    if faults:
        raise AnswersDoNotFit(instrument.name, faults)
    return Answers(instrument=instrument.name, given=tuple(answers))


def _fault(item: Item, value: int | float | str | None) -> str:
    """Say what is wrong with a value; "" when nothing is."""
    if value is None:
        return "needs an answer" if item.required else ""
    if isinstance(item, LikertItem):
        right = type(value) is int and value in item.scale.points
    elif isinstance(item, ChoiceItem):
        right = value in [option.name for option in item.options]
    elif isinstance(item, NumberItem):
        right = _allowed(item, value)
    else:
        right = isinstance(value, str) and 0 < len(value) <= LONGEST_TEXT
    return "" if right else f"given {value!r:.60}, but the answers are {item.answers}"


def _allowed(item: NumberItem, value: int | float | str) -> bool:
    if isinstance(value, str | bool) or not isfinite(value):
        return False
    low = item.lowest is None or value >= item.lowest
    high = item.highest is None or value <= item.highest
    return low and high and (not item.whole or value == int(value))
