"""`omnistudy sweep` as a person types it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pandas as pd
import pytest
from small_sweep import ARMS, GAINS, PROTOCOL, SHORT

from omnistudy.cli.app import main

ASKED = (PROTOCOL, GAINS, ARMS, *SHORT, "--trials", "1", "--workers", "1")


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", "sweep", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def gains(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of studies with one finished sweep."""
    folder = tmp_path_factory.mktemp("studies")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("OMNISTUDY_STUDIES", str(folder))
        assert run(patch, *ASKED, "--name", "gains") == 0
    return folder


@pytest.fixture
def studies(gains: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("OMNISTUDY_STUDIES", str(gains))
    return gains


def test_what_would_run_is_said_first_and_a_dry_run_stops_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("OMNISTUDY_STUDIES", str(tmp_path))
    assert run(monkeypatch, *ASKED, "--dry-run") == 0
    said = capsys.readouterr().out
    assert "4 points (2 design x 2 nuisance), 2 trials each: 2 participants" in said
    assert "to run: 8 trials at 4 points with basic, 1 worker: about" in said
    assert list(tmp_path.iterdir()) == []


def test_a_finished_sweep_has_nothing_left(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "run", *ASKED, "--name", "gains") == 0
    assert "nothing is left to run" in capsys.readouterr().out


def test_the_only_sweep_is_shown_without_its_name(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    studies: Path,
) -> None:
    table, front = tmp_path / "rows.csv", tmp_path / "front.png"
    assert run(monkeypatch, "show", "--csv", str(table), "--draw", str(front)) == 0
    said = capsys.readouterr().out
    assert "cannot be told apart from the best: rows" in said
    assert "front of collisions, time and work against the hand: rows" in said
    assert len(pd.read_csv(table)) == 8
    assert front.read_bytes().startswith(b"\x89PNG")
    assert run(monkeypatch, "show", "--csv", str(table)) == 2
    assert run(monkeypatch, "show", "--draw", str(front)) == 1


def test_a_ranking_is_read_as_json(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "show", "gains", "--by", "duration_s", "--worst", "--json") == 0
    ranking = json.loads(capsys.readouterr().out)
    assert (ranking["by"], ranking["order"]) == ("duration_s", "worst_tenth")
    assert ranking["keys"] == ["law.stiffness.x"]
    assert sorted(point["row"] for point in ranking["points"]) == [1, 2]


def test_sweeps_are_listed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "list", "--json") == 0
    assert json.loads(capsys.readouterr().out) == [
        {"name": "gains", "protocol": PROTOCOL, "points": 4, "finished": 4, "failed": 0}
    ]


def test_a_row_is_taken_and_the_page_is_checked(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    studies: Path,
) -> None:
    page = tmp_path / "chosen.yaml"
    assert run(monkeypatch, "take", "2", "-o", str(page)) == 0
    text = page.read_text()
    assert text.startswith("# Row 2 of the sweep 'gains' over utah2017_component, omnistudy ")
    assert "# law.stiffness.x = 400\n" in text
    assert "# design hash " in text
    monkeypatch.setattr(sys, "argv", ["omnistudy", "protocol", "check", str(page)])
    with pytest.raises(SystemExit) as end:
        main()
    assert not end.value.code
    assert "no faults" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (("show", "gain"), 1, "no sweep 'gain'"),
        (("take", "7", "-o", "page.yaml"), 1, "there is no row 7"),
        (("take", "1", "--sweep", "gain", "-o", "page.yaml"), 1, "did you mean 'gains'"),
        (("show", "--by", "colisions"), 1, "did you mean 'collisions'"),
        ((PROTOCOL, GAINS, "--name", "gains"), 1, "asks another question already"),
        ((PROTOCOL, GAINS, "--launcher", "slurm"), 1, "unknown launcher 'slurm'"),
        ((PROTOCOL, GAINS, "--search", "grid"), 2, "only optuna is known"),
        ((PROTOCOL, GAINS, "--search", "optuna", "--launcher", "ray"), 2, "leave --launcher out"),
        ((PROTOCOL, "law.stiffness.x="), 1, "given no values"),
        ((PROTOCOL, "law.stifness.x=1,2"), 1, "did you mean 'stiffness'"),
        (("utah2017", GAINS), 1, "no protocol 'utah2017'"),
        ((PROTOCOL,), 2, "Missing argument"),
    ],
)
def test_bad_input_is_answered_in_one_sentence(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    studies: Path,
    arguments: tuple[str, ...],
    status: int,
    said: str,
) -> None:
    assert run(monkeypatch, *arguments) == status
    assert said in " ".join(capsys.readouterr().err.split())
