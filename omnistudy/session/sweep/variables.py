"""What was typed, read in Hydra's own grammar: keys with one value, with several, intervals."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import (
    ChoiceSweep,
    IntervalSweep,
    Override,
    Quote,
    QuotedString,
    RangeSweep,
)
from hydra.errors import HydraException

from omnistudy.errors.sweep import (
    EmptyInterval,
    NotASweepOverride,
    NothingSwept,
    NoValues,
    RoleOfNoKey,
    SweptTwice,
)
from omnistudy.session.sweep.question import Role, Variable

NUISANCE = ("operator", "participants")
"""Keys under these are what one meets, unless `--design` says otherwise."""


@dataclass(frozen=True, slots=True)
class Interval:
    """From low to high; `whole` for whole numbers only."""

    low: float
    high: float
    whole: bool


@dataclass(frozen=True, slots=True)
class Swept:
    """A variable with its values, listed or in an interval."""

    variable: Variable
    values: tuple[Any, ...] | Interval

    @property
    def ends(self) -> tuple[Any, ...]:
        """The first and the last value; of an interval its ends."""
        if isinstance(self.values, Interval):
            whole = int if self.values.whole else float
            return (whole(self.values.low), whole(self.values.high))
        return (self.values[0], self.values[-1])


@dataclass(frozen=True, slots=True)
class Asked:
    """The words of the command line, sorted.

    overrides : keys with one value. launcher : settings of Hydra's launcher.
    """

    swept: tuple[Swept, ...]
    overrides: tuple[str, ...]
    launcher: tuple[str, ...]


def read_words(
    words: Sequence[str], nuisance: Sequence[str] = (), design: Sequence[str] = ()
) -> Asked:
    """Read `law.stiffness.x=100,200 operator.arm.stiffness_median=interval(100,300)`.

    nuisance, design : keys whose role is not the one that their place suggests.

    Raises NotASweepOverride, NoValues, EmptyInterval, SweptTwice, NothingSwept, RoleOfNoKey.
    """
    swept: list[Swept] = []
    overrides: list[str] = []
    launcher: list[str] = []
    for word in words:
        override = _parsed(word)
        if override.is_hydra_override():
            launcher.append(word)
        elif override.is_sweep_override():
            swept.append(_swept(override, word, nuisance, design))
        elif override.value() == "" and not override.is_delete():
            raise NoValues(override.key_or_group)
        else:
            overrides.append(word)
    keys = [one.variable.key for one in swept]
    for key in keys:
        if keys.count(key) > 1 or any(_parsed(word).key_or_group == key for word in overrides):
            raise SweptTwice(key)
    if not swept:
        raise NothingSwept
    for option, given in (("--nuisance", nuisance), ("--design", design)):
        for key in given:
            if key not in keys:
                raise RoleOfNoKey(option, key, keys)
    return Asked(tuple(swept), tuple(overrides), tuple(launcher))


def override_text(key: str, value: Any) -> str:
    """Write a value so that Hydra reads it back as it is."""
    if value is None:
        return f"{key}=null"
    if isinstance(value, str) and not re.fullmatch(r"[A-Za-z_][\w./-]*", value):
        return f"{key}={quoted(value)}"
    return f"{key}={value if isinstance(value, str) else json.dumps(value)}"


def quoted(text: str) -> str:
    """Quote any text, such as a path, for Hydra's grammar."""
    return QuotedString(text=text, quote=Quote.single).with_quotes()


def _parsed(word: str) -> Override:
    try:
        (override,) = OverridesParser.create().parse_overrides([word])
    except HydraException as fault:
        raise NotASweepOverride(word) from fault
    return override


def _swept(override: Override, word: str, nuisance: Sequence[str], design: Sequence[str]) -> Swept:
    key = override.key_or_group
    found = override.value()
    values: tuple[Any, ...] | Interval
    if isinstance(found, IntervalSweep) and found.start is not None and found.end is not None:
        if not found.start < found.end:
            raise EmptyInterval(key, found.start, found.end)
        values = Interval(found.start, found.end, isinstance(found.start, int))
    elif isinstance(found, ChoiceSweep | RangeSweep):
        found.shuffle = False  # the same words must always ask the same
        values = tuple(_plain(value) for value in override.sweep_iterator())
        if isinstance(found, RangeSweep) and values and values[-1] == found.stop:
            values = values[:-1]  # a range ends before its end; Hydra's sum fell short of it
    else:
        raise NotASweepOverride(word)
    if not values:
        raise NoValues(key)
    role = _role(key, nuisance, design)
    return Swept(Variable(key=key, role=role, asked=word.partition("=")[2]), values)


def _role(key: str, nuisance: Sequence[str], design: Sequence[str]) -> Role:
    if key in nuisance:
        return "nuisance"
    if key in design:
        return "design"
    return "nuisance" if key.partition(".")[0] in NUISANCE else "design"


def _plain(value: Any) -> Any:
    if isinstance(value, QuotedString):
        return value.text
    if isinstance(value, list):
        return [_plain(item) for item in value]
    if isinstance(value, float):
        return float(f"{value:.12g}")  # range(0,1,0.1) adds up to 0.7000000000000001
    return value
