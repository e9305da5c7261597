"""Pages call conditions by their masked labels; names are nowhere in them unless asked for."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import omnistudy
from omnistudy.view.film import film
from omnistudy.view.live_setting import live_setting
from omnistudy.view.trials import trial_list


def words(value: Any) -> Iterator[str]:
    """Give every text that stands somewhere in a page's content."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for part in value.values():
            yield from words(part)
    elif isinstance(value, list):
        for part in value:
            yield from words(part)


def test_a_masked_page_holds_the_label_and_no_name(driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        table = study.conditions()
        first = study.trials().iloc[0]["condition"]
        label = dict(zip(table["condition"], table["masked_label"], strict=True))[first]
        contents = [film(study, 1), trial_list(study), live_setting(study, 1)]
    assert len(set(table["condition"])) == 6
    for content in contents:
        held = set(words(json.loads(content.model_dump_json())))
        assert label in held
        assert held.isdisjoint(set(table["condition"]))


def test_whoever_asks_reads_names(driven_study: Path) -> None:
    with omnistudy.open(driven_study) as study:
        names = list(study.trials()["condition"])
        listed = trial_list(study, unmask=True)
        second = film(study, 2, unmask=True)
        setting = live_setting(study, 1, unmask=True)
    assert [one.condition for one in listed.trials] == names
    assert (second.condition, second.masked) == (names[1], False)
    assert (setting.label, setting.masked) == (names[0], False)
    assert [coming.label for coming in setting.coming] == names[2:]
