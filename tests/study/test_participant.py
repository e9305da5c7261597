"""One participant and what became of each trial."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli.app import main
from omnistudy.errors.study import UnknownParticipant
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import run_trials
from omnistudy.store import open_study
from omnistudy.study import create_study
from omnistudy.study.participant import participant_record

SHORT = ("world=primitive_c", "routes=[through]", "participants.count=2", "order.block_length=1")


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study of two, of whom the first has driven one trial."""
    path = tmp_path_factory.mktemp("studies") / "first.db"
    create_study(compose_protocol("utah2017_component", SHORT), path, "first")
    run_trials(path, limit=1, workers=1)
    return path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_trials_come_in_order_with_what_is_known_of_them(study: Path) -> None:
    with open_study(study) as opened:
        found = participant_record(opened, "P01")
        stored = opened.trials().iloc[0]
    assert (found.code, found.kind, found.group) == ("P01", "virtual", None)
    assert [trial.position for trial in found.trials] == [1, 2, 3, 4, 5, 6]
    driven, *waiting = found.trials
    assert driven.status in {"completed", "timed_out"}
    assert driven.duration_s == stored["duration_s"]
    assert driven.collisions == stored["collisions"]
    assert isinstance(driven.collisions, int)
    for trial in waiting:
        assert (trial.status, trial.duration_s, trial.collisions) == ("planned", None, None)


def test_a_participant_is_shown_to_people_and_to_programs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], study: Path
) -> None:
    assert run(monkeypatch, "participant", "show", str(study), "P02", "--json") == 0
    shown = json.loads(capsys.readouterr().out)
    assert [trial["status"] for trial in shown["trials"]] == ["planned"] * 6
    assert run(monkeypatch, "participant", "show", str(study), "P01") == 0
    printed = capsys.readouterr().out
    assert "P01: virtual" in printed
    assert "centre_front_10" in printed


def test_an_unknown_code_is_one_sentence(study: Path) -> None:
    with (
        open_study(study) as opened,
        pytest.raises(UnknownParticipant, match="its participants are P01, P02"),
    ):
        participant_record(opened, "P3")


@pytest.mark.parametrize(("named", "offered"), [("first", ["P01", "P02"]), ("nothing", [])])
def test_the_shell_completes_codes_of_the_study_before(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    study: Path,
    named: str,
    offered: list[str],
) -> None:
    monkeypatch.setenv("OMNISTUDY_STUDIES", str(study.parent))
    monkeypatch.setenv("_OMNISTUDY_COMPLETE", "complete_bash")
    monkeypatch.setenv("COMP_WORDS", f"omnistudy participant show {named} P")
    monkeypatch.setenv("COMP_CWORD", "4")
    run(monkeypatch)
    assert capsys.readouterr().out.split() == offered
