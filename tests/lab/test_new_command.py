"""`omnistudy new` as a person types it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli.app import main
from omnistudy.lab import NOUNS


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to stand in, with no lab."""
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_a_law_is_started_in_lab_and_the_next_steps_are_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "new", "law", "grip") == 0
    assert capsys.readouterr().out.splitlines() == [
        "wrote lab/lab_parts/__init__.py",
        "wrote lab/lab_parts/grip.py",
        "wrote lab/law/grip.yaml",
        "wrote lab/tests/test_grip.py",
        "wrote lab/pyproject.toml",
        "next:",
        "  pip install --editable lab",
        "  export OMNISTUDY_CONF=lab",
        "  pytest lab",
        "  omnistudy law show grip",
        "  omnistudy law draw grip -o grip.svg",
    ]
    assert run(monkeypatch, "new", "law", "soft") == 0
    assert "added a line to lab/pyproject.toml" in capsys.readouterr().out


@pytest.mark.parametrize("noun", NOUNS)
def test_a_dry_run_says_what_would_be_written_and_writes_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], here: Path, noun: str
) -> None:
    assert run(monkeypatch, "new", noun, "grip", "--dry-run") == 0
    lines = capsys.readouterr().out.splitlines()
    assert all(line.startswith("would write lab/") for line in lines)
    assert list(here.iterdir()) == []
    assert run(monkeypatch, "new", noun, "grip", "--dry-run", "--json") == 0
    said = json.loads(capsys.readouterr().out)
    assert [f"would write {row['file']}" for row in said["files"]] == lines
    assert said["written"] is False


@pytest.mark.parametrize("noun", NOUNS)
def test_into_names_another_folder_and_json_names_the_files(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], here: Path, noun: str
) -> None:
    assert run(monkeypatch, "new", noun, "grip", "--into", "deep/ours", "--json") == 0
    said = json.loads(capsys.readouterr().out)
    assert said["written"] is True
    assert all(Path(row["file"]).is_file() for row in said["files"])
    assert {Path(row["file"]).parts[:2] for row in said["files"]} == {("deep", "ours")}
    assert "pytest deep/ours" in said["next"]


def test_conf_is_the_folder_unless_into_names_one(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], here: Path
) -> None:
    (here / "ours").mkdir()
    assert run(monkeypatch, "--conf", "ours", "new", "world", "bend") == 0
    assert (here / "ours" / "world" / "bend.yaml").is_file()
    assert "export" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("noun", "check"),
    [
        ("world", ("world", "check", "mine")),
        ("protocol", ("protocol", "check", "mine")),
        ("survey", ("survey", "show", "mine")),
    ],
)
def test_a_page_is_good_as_it_is_written(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    noun: str,
    check: tuple[str, ...],
) -> None:
    assert run(monkeypatch, "new", noun, "mine") == 0
    capsys.readouterr()
    assert run(monkeypatch, "--conf", "lab", *check) == 0
    printed = capsys.readouterr().out
    assert noun == "survey" or "no faults" in printed
    assert run(monkeypatch, "--conf", "lab", noun, "list", "--json") == 0
    assert "mine" in {row["name"] for row in json.loads(capsys.readouterr().out)}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("law", "component"), "there is a law 'component' already"),
        (("controller", "class"), "a word of Python itself"),
        (("world", "My World"), "write small letters"),
    ],
)
def test_a_name_that_will_not_do_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    here: Path,
    arguments: tuple[str, ...],
    said: str,
) -> None:
    assert run(monkeypatch, "new", *arguments) == 1
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert said in told
    assert list(here.iterdir()) == []
