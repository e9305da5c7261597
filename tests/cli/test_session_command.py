"""`omnistudy session`, `operator` and `demo` as a person types them."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli import demo as demo_command
from omnistudy.cli.app import main
from omnistudy.store import StudyWriter

SHORT = (
    "utah2017_component",
    "world=primitive_c",
    "routes=[through]",
    "participants.count=1",
    "order.block_length=1",
)


@pytest.fixture
def studies(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("OMNISTUDY_STUDIES", str(tmp_path))
    return tmp_path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *arguments])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


@pytest.mark.slow
def test_a_session_is_planned_run_in_two_goes_and_planned_again(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "study", "create", *SHORT, "--name", "first") == 0
    capsys.readouterr()

    assert run(monkeypatch, "session", "plan", "first", "P01", "--json") == 0
    planned = json.loads(capsys.readouterr().out)
    assert [trial["position"] for trial in planned] == [1, 2, 3, 4, 5, 6]
    assert {trial["status"] for trial in planned} == {"planned"}
    assert planned[1]["start_s"] == pytest.approx(planned[0]["duration_s"] + 60.0)

    assert run(monkeypatch, "session", "run", "first", "--dry-run") == 0
    assert capsys.readouterr().out == "6 trials would run\n"
    assert run(monkeypatch, "session", "run", "first", "P01", "--trials", "2", "--json") == 0
    first = json.loads(capsys.readouterr().out)
    assert first["remaining"] == 4
    assert run(monkeypatch, "session", "run", "first", "--workers", "1") == 0
    assert "0 still planned" in capsys.readouterr().out

    assert run(monkeypatch, "session", "plan", "first", "P01") == 0
    assert "planned" not in capsys.readouterr().out.replace("expected", "")


def test_a_trial_that_a_killed_run_left_running_is_announced_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "study", "create", *SHORT, "--name", "first") == 0
    with StudyWriter.open(studies / "first.db") as writer:
        writer.start_trial(writer.planned_trials()[0].id)
    capsys.readouterr()
    assert run(monkeypatch, "session", "run", "first", "--dry-run") == 0
    assert capsys.readouterr().out == "6 trials would run\n"


def test_an_unknown_participant_and_a_changed_protocol_are_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "study", "create", *SHORT, "--name", "first") == 0
    assert run(monkeypatch, "session", "plan", "first", "P2") == 1
    assert "P01" in capsys.readouterr().err
    assert run(monkeypatch, "session", "run", "first", "--protocol", "utah2017_component") == 1
    assert "world" in capsys.readouterr().err
    assert run(monkeypatch, "session", "run", "nothing") == 1
    assert capsys.readouterr().err.startswith("error: ")


def test_operators_are_listed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(monkeypatch, "operator", "list", "--json") == 0
    kinds = [row["kind"] for row in json.loads(capsys.readouterr().out)["kinds"]]
    assert {"recorded", "virtual_driver"} <= set(kinds)


def test_a_calibration_never_overwrites_a_page(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    page = tmp_path / "virtual_driver.yaml"
    page.write_text("kind: virtual_driver\n")
    assert run(monkeypatch, "operator", "calibrate", "-o", str(page)) == 2
    assert "exists" in capsys.readouterr().err
    assert page.read_text() == "kind: virtual_driver\n"


@pytest.mark.slow
@pytest.mark.slow
def test_the_quick_demo_draws_two_trials(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], studies: Path
) -> None:
    assert run(monkeypatch, "demo", "--quick", "--json") == 0
    shown = json.loads(capsys.readouterr().out)
    assert [trial["condition"] for trial in shown["trials"]] == ["none", "full"]
    assert (studies / "demo_quick.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
@pytest.mark.slow
def test_the_demo_makes_both_studies_and_the_report_and_goes_on_where_it_was(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    studies: Path,
    tmp_path: Path,
) -> None:
    lab = tmp_path / "lab"
    lab.mkdir()
    for name in (demo_command.STUDY, demo_command.ARMS):
        count = "" if name == demo_command.ARMS else "\norder: {block_length: 1}"
        (lab / f"small_{name}.yaml").write_text(
            f"defaults: [{name}, override world: primitive_c, _self_]\n"
            f"routes: [through]\nparticipants: {{count: 1}}{count}\n"
        )
    monkeypatch.setenv("OMNISTUDY_CONF", str(lab))
    monkeypatch.setattr(demo_command, "STUDY", f"small_{demo_command.STUDY}")
    monkeypatch.setattr(demo_command, "ARMS", f"small_{demo_command.ARMS}")

    assert run(monkeypatch, "demo", "--json") == 0
    made = json.loads(capsys.readouterr().out)
    page = Path(made["report"]).read_text()
    assert "virtual" in page
    before = Path(made["study"]).read_bytes()

    assert run(monkeypatch, "demo", "--json") == 0
    assert json.loads(capsys.readouterr().out) == made
    assert Path(made["study"]).read_bytes() == before
    assert Path(made["report"]).read_text() == page
