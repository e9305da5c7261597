from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli.app import main

NAME = "utah2017_component"


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", "protocol", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_list_names_every_protocol(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "list", "--json") == 0
    assert NAME in {entry["name"] for entry in json.loads(capsys.readouterr().out)}


def test_show_prints_one_page_with_every_number(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", NAME) == 0
    page = capsys.readouterr().out
    for text in (
        "design hash",
        "centre_front_20",
        "law.compliance_centre: 0.0 -> 0.2",
        "participant 4",
        "session.expected",
        "boundary.layer_x 0.15 m",
        "ethics.note",
    ):
        assert text in page, text


def test_show_takes_changes_and_prints_the_canonical_text(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "show", NAME, "participants.count=3", "--json") == 0
    assert json.loads(capsys.readouterr().out)["participants"]["count"] == 3


def test_check_of_a_sound_file_says_so(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "check", NAME) == 0
    assert "no faults; 6 conditions, 8 virtual participants" in capsys.readouterr().out


def test_check_tells_every_fault_and_exits_1(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    page = tmp_path / "mine.yaml"
    page.write_text(
        f"defaults: [{NAME}, _self_]\nname: mine\nlaw: {{stifness: 1}}\nroutes: [red-green]\n"
    )
    assert run(monkeypatch, "check", str(page)) == 1
    said = capsys.readouterr().err
    assert f"error: {page} has 2 faults:" in said
    assert "law.stifness: unknown key" in said
    assert run(monkeypatch, "check", str(page), "--json") == 1
    assert len(json.loads(capsys.readouterr().out)["faults"]) == 2


def test_diff_tells_what_a_file_changes(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    page = tmp_path / "mine.yaml"
    page.write_text(f"defaults: [{NAME}, _self_]\nsession: {{pause: 30}}\n")
    assert run(monkeypatch, "diff", NAME, str(page)) == 0
    assert capsys.readouterr().out == "session.pause: 60.0 -> 30.0\n"
    assert run(monkeypatch, "diff", NAME, NAME) == 0
    assert capsys.readouterr().out == "no difference\n"
