"""docs/database.md against a real database."""

from __future__ import annotations

import re
import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from omnistudy.channel import SAMPLE_CHANNELS, Stream

PAGE = Path(__file__).resolve().parents[2] / "docs" / "database.md"


@pytest.fixture(scope="module")
def documented() -> dict[str, dict[str, tuple[str, str, str]]]:
    """Give table -> column -> (type, unit, meaning), as the page says."""
    sections = re.split(r"^### ", PAGE.read_text(encoding="utf-8"), flags=re.M)[1:]
    return {
        section.split("\n", 1)[0].strip(): {
            cells[0]: (cells[1], cells[2], cells[3])
            for line in section.splitlines()
            if line.startswith("|")
            and (cells := [cell.strip() for cell in line.strip("|").split("|")])[0]
            not in ("column", "---")
        }
        for section in sections
    }


def test_every_column_is_explained_and_no_other(
    study: Path, documented: dict[str, dict[str, tuple[str, str, str]]]
) -> None:
    with closing(sqlite3.connect(study)) as database:
        tables = [name for (name,) in database.execute("SELECT name FROM pragma_table_list")]
        real = {
            table: [
                name
                for (name,) in database.execute("SELECT name FROM pragma_table_info(?)", (table,))
            ]
            for table in tables
            if not table.startswith("sqlite_")
        }
    assert {table: list(columns) for table, columns in documented.items()} == real


def test_every_explanation_says_something(
    documented: dict[str, dict[str, tuple[str, str, str]]],
) -> None:
    for columns in documented.values():
        for kind, unit, meaning in columns.values():
            assert kind in {"text", "integer", "real", "blob"}
            assert meaning
            assert (kind == "real") <= bool(unit)


def test_types_are_those_of_the_tables(
    study: Path, documented: dict[str, dict[str, tuple[str, str, str]]]
) -> None:
    shown = {"VARCHAR": "text", "TEXT": "text", "INTEGER": "integer", "DOUBLE": "real"}
    with closing(sqlite3.connect(study)) as database:
        query = (
            "SELECT list.name, info.name, info.type FROM pragma_table_list AS list "
            "JOIN pragma_table_info(list.name) AS info "
            "WHERE list.type = 'table' AND list.name NOT LIKE 'sqlite_%'"
        )
        for table, column, declared in database.execute(query):
            kind = shown.get(declared.split("(")[0], declared.lower())
            assert documented[table][column][0] == kind, (table, column)


def test_units_of_samples_are_those_of_the_channels(
    documented: dict[str, dict[str, tuple[str, str, str]]],
) -> None:
    for channel in SAMPLE_CHANNELS:
        assert documented["sample"][channel.name][1:] == (channel.unit, channel.description)


def test_the_recipes_read_what_was_written(
    driven: Path, stream: Stream, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "studies").mkdir()
    driven.rename(tmp_path / "studies" / "small.db")
    monkeypatch.chdir(tmp_path)
    recipes = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), flags=re.S)
    assert len(recipes) == 2
    names: dict[str, object] = {}
    for recipe in recipes:
        exec(recipe, names)
    values, trials = names["values"], names["trials"]
    assert isinstance(values, np.ndarray)
    assert np.array_equal(values, stream.data)
    assert isinstance(trials, pd.DataFrame)
    assert len(trials) == 6
