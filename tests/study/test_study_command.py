from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli.app import main

NAME = "utah2017_component"


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_a_study_is_made_listed_and_counted(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "study", "create", NAME, "participants.count=2", "--name", "a") == 0
    assert "2 participants, 20 trials planned" in capsys.readouterr().out
    assert run(monkeypatch, "study", "list", "--json") == 0
    (listed,) = json.loads(capsys.readouterr().out)
    assert (listed["name"], listed["kind"], listed["trials"]) == ("a", "virtual", 20)
    assert run(monkeypatch, "study", "status", "a", "--json") == 0
    status = json.loads(capsys.readouterr().out)
    assert [one["planned"] for one in status["participants"]] == [10, 10]
    assert run(monkeypatch, "participant", "list", "a", "--json") == 0
    assert [one["code"] for one in json.loads(capsys.readouterr().out)] == ["P01", "P02"]
    assert run(monkeypatch, "study", "upgrade", "a") == 0
    assert "is up to date" in capsys.readouterr().out
    assert run(monkeypatch, "study", "create", NAME, "--name", "a") == 1
    assert "exists already" in capsys.readouterr().err


def test_a_changed_protocol_is_refused_with_a_diff(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    run(monkeypatch, "study", "create", NAME, "participants.count=1", "--name", "a")
    assert run(monkeypatch, "study", "diff", "a", NAME, "participants.count=1") == 0
    assert run(monkeypatch, "study", "diff", "a") == 1
    assert "participants.count: 1 -> 8" in capsys.readouterr().err


def test_the_protocol_that_a_study_was_frozen_with_is_shown(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    changes = ("participants.count=1", "session.pause=17")
    run(monkeypatch, "study", "create", NAME, *changes, "--name", "a")
    capsys.readouterr()
    assert run(monkeypatch, "study", "show", "a", "--json") == 0
    frozen = capsys.readouterr().out
    assert json.loads(frozen)["session"]["pause"] == 17.0
    assert run(monkeypatch, "protocol", "show", NAME, *changes, "--json") == 0
    assert capsys.readouterr().out == frozen
    assert run(monkeypatch, "study", "show", "a") == 0
    shown = capsys.readouterr().out
    assert run(monkeypatch, "protocol", "show", NAME, *changes) == 0
    assert capsys.readouterr().out == shown


def test_a_dry_run_writes_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "study", "create", NAME, "--dry-run") == 0
    assert f"would write {studies / NAME}.db: 8 virtual" in capsys.readouterr().out
    assert not studies.exists()


def test_tables_are_for_people(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    run(monkeypatch, "study", "create", NAME, "participants.count=1")
    for verb in (("study", "list"), ("study", "status", NAME), ("participant", "list", NAME)):
        capsys.readouterr()
        assert run(monkeypatch, *verb) == 0
        assert "10" in capsys.readouterr().out or verb[0] == "participant"


def test_a_damaged_study_is_listed_with_its_fault(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    studies.mkdir()
    (studies / "broken.db").write_bytes(b"no database at all")
    assert run(monkeypatch, "study", "list", "--json") == 0
    (listed,) = json.loads(capsys.readouterr().out)
    assert "broken.db" in listed["fault"]
