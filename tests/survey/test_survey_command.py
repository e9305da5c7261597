"""`omnistudy survey` as a person types it."""

from __future__ import annotations

import json
import sys

import pytest

from omnistudy.cli.app import main


@pytest.fixture(autouse=True)
def _no_lab(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", "survey", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_surveys_are_listed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "list", "--json") == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)}
    assert rows["utah2017"]["items"] == 11
    assert run(monkeypatch, "list") == 0
    assert "utah2017" in capsys.readouterr().out


def test_a_survey_is_shown_with_its_answers(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", "utah2017", "--json") == 0
    shown = json.loads(capsys.readouterr().out)
    assert shown["items"][0]["scale"]["anchors"][0] == {"value": 1, "label": "very poor"}
    assert run(monkeypatch, "show", "utah2017") == 0
    printed = capsys.readouterr().out
    assert "1 very poor, 2 poor, 3 average, 4 good, 5 very good" in printed
    assert "centre_front_10, centre_front_20" in printed
    assert "\x1b" not in printed


def test_a_wrong_name_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", "utah2018") == 1
    assert "did you mean 'utah2017'" in capsys.readouterr().err
