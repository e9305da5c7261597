"""Tables, JSON and progress as a person and a program read them."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from omnistudy.cli import output


@dataclass(frozen=True)
class Measured:
    name: str
    seconds: float


def test_json_is_plain(capsys: pytest.CaptureFixture[str]) -> None:
    output.print_json(
        {
            "row": Measured("a", math.nan),
            "array": np.array([1.0, 2.5]),
            "number": np.float64(0.5),
            "path": Path("a.db"),
            "word": "Größe",
        }
    )
    assert json.loads(capsys.readouterr().out) == {
        "row": {"name": "a", "seconds": None},
        "array": [1.0, 2.5],
        "number": 0.5,
        "path": "a.db",
        "word": "Größe",
    }


def test_table_cuts_nothing_where_there_is_no_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    long = "x" * 300
    output.print_table("Trials [3]", ["name", "time, s"], [(long, 1.23456789), ("[b]", None)])
    shown = capsys.readouterr().out
    assert "Trials [3]" in shown
    assert long in shown
    assert "[b]" in shown
    assert "1.23457" in shown
    assert "\x1b" not in shown


def test_numbers_stand_to_the_right(capsys: pytest.CaptureFixture[str]) -> None:
    output.print_table("", ["n", "name"], [(7, "a"), (1000, "b"), (None, "c")])
    rows = capsys.readouterr().out.rstrip().splitlines()[-3:]
    assert [row.split() for row in rows] == [["7", "a"], ["1000", "b"], ["-", "c"]]
    assert rows[0].index("7") == rows[1].index("1000") + 3 == rows[2].index("-")


def test_progress_without_a_terminal_is_plain_lines(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = iter([0.0, 1.0, 6.0, 8.0])
    monkeypatch.setattr(output.time, "monotonic", lambda: next(clock))
    with output.progress("Trials", 4) as advance:
        advance()
        advance(2)
        advance()
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.splitlines() == [
        "Trials: 3 of 4, 6 s elapsed, about 2 s remaining",
        "Trials: 4 of 4, 8 s elapsed, about 0 s remaining",
    ]
