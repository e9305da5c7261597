"""From an instrument's name or file to the instrument."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from pydantic import ValidationError

from omnistudy.errors.survey import BrokenInstrument, UnknownInstrument
from omnistudy.registry.faults import explain
from omnistudy.registry.pages import page_content, page_file, page_names
from omnistudy.survey.instrument import Instrument


class InstrumentEntry(NamedTuple):
    """One line of a list of instruments; `fault` says why a page cannot be read.

    items : how many questions it has.
    """

    name: str
    title: str
    language: str
    items: int
    file: Path
    fault: str = ""


def instrument_names(lab: Path | None = None) -> tuple[str, ...]:
    """Name every instrument in the lab's folder and in ours."""
    return page_names("survey", lab)


def instrument_file(name_or_file: str | Path, lab: Path | None = None) -> Path:
    """Give the YAML page of an instrument: a path that exists, else a name in conf/survey.

    The lab's folder is asked first. Raises UnknownInstrument.
    """
    page = page_file("survey", name_or_file, lab)
    if page is None:
        raise UnknownInstrument(str(name_or_file), instrument_names(lab))
    return page


def listed_instruments(lab: Path | None = None) -> tuple[InstrumentEntry, ...]:
    """List the instruments that can be given by name, faulty ones too."""
    return tuple(_listed(name, instrument_file(name, lab)) for name in instrument_names(lab))


def _listed(name: str, file: Path) -> InstrumentEntry:
    try:
        found = load_instrument(file)
    except BrokenInstrument as broken:
        return InstrumentEntry(name, "", "", 0, file, str(broken))
    return InstrumentEntry(name, found.title, found.language, len(found.items), file)


def load_instrument(name_or_file: str | Path, lab: Path | None = None) -> Instrument:
    """Read an instrument; raises UnknownInstrument, or BrokenInstrument with every fault."""
    page = instrument_file(name_or_file, lab)
    tree = page_content(page, BrokenInstrument)
    try:
        return Instrument.model_validate(tree)
    except ValidationError as faults:
        raise BrokenInstrument(page, explain(faults, Instrument, tree, str(page))) from faults
