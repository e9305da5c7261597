"""What a virtual participant says when it is asked: at once, drawn from its seed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omnistudy.seeds import generator
from omnistudy.survey import (
    Answer,
    Answers,
    ChoiceItem,
    ConsentAnswer,
    ConsentForm,
    Instrument,
    Item,
    LikertItem,
    NumberItem,
)
from omnistudy.survey.answers import checked

SPAN = 100.0
"""How far a number is drawn from its one bound (ours)."""


@dataclass(frozen=True, slots=True)
class VirtualDialogue:
    """A `Dialogue` that answers by itself, for rehearsals; it means nothing by what it says."""

    seed: str
    """Of the participant."""

    def instruct(self) -> None:
        """Be ready."""

    def rest(self, seconds: float) -> None:
        """Need none."""

    def count_down(self, trial: int) -> None:
        """Need none."""

    def consent(self, form: ConsentForm) -> ConsentAnswer:
        """Agree to everything."""
        ticked = tuple(one.name for one in form.asked)
        return ConsentAnswer(version=form.version, agreed=True, ticked=ticked)

    def ask(self, instrument: Instrument) -> Answers:
        """Draw an allowed answer to every question."""
        chance = generator(self.seed, f"answers to {instrument.name}")
        drawn = [Answer(item=item.name, value=_drawn(item, chance)) for item in instrument.items]
        return checked(instrument, drawn)

    def thank(self) -> None:
        """Go."""


def _drawn(item: Item, chance: np.random.Generator) -> int | float | str:
    if isinstance(item, LikertItem):
        return int(chance.choice(item.scale.points))
    if isinstance(item, ChoiceItem):
        return item.options[int(chance.integers(len(item.options)))].name
    if isinstance(item, NumberItem):
        return _number(item, chance)
    return "virtual"


def _number(item: NumberItem, chance: np.random.Generator) -> int | float:
    low, high = item.lowest, item.highest
    if low is None:
        low = 0.0 if high is None else high - SPAN
    if high is None:
        high = low + SPAN
    if item.whole:
        return int(chance.integers(int(np.ceil(low)), int(np.floor(high)), endpoint=True))
    return float(chance.uniform(low, high))
