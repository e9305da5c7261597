"""Instruments: what people are asked, in whose words; asks nobody."""

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
    "ChoiceItem",
    "Instrument",
    "InstrumentEntry",
    "Item",
    "LikertItem",
    "NumberItem",
    "Option",
    "Question",
    "Scale",
    "TextItem",
    "instrument_file",
    "instrument_names",
    "listed_instruments",
    "load_instrument",
]
