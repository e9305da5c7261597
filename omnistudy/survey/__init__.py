"""Instruments: what people are asked, in whose words; asks nobody."""

from omnistudy.survey.answers import Answer, Answers
from omnistudy.survey.consent_form import Asked, ConsentAnswer, ConsentForm, Section
from omnistudy.survey.find import (
    InstrumentEntry,
    instrument_file,
    instrument_names,
    listed_instruments,
    load_instrument,
)
from omnistudy.survey.instrument import Instrument
from omnistudy.survey.item import (
    ChoiceItem,
    Item,
    LikertItem,
    NumberItem,
    Option,
    Question,
    TextItem,
)
from omnistudy.survey.scale import Anchor, Scale

__all__ = [
    "Anchor",
    "Answer",
    "Answers",
    "Asked",
    "ChoiceItem",
    "ConsentAnswer",
    "ConsentForm",
    "Instrument",
    "InstrumentEntry",
    "Item",
    "LikertItem",
    "NumberItem",
    "Option",
    "Question",
    "Scale",
    "Section",
    "TextItem",
    "instrument_file",
    "instrument_names",
    "listed_instruments",
    "load_instrument",
]
