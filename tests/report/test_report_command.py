"""`omnistudy report` on a real study, made by the virtual driver."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from omnistudy.cli.app import main
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session import run_trials
from omnistudy.study import create_study

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("studies") / "small.db"
    short = ("world=primitive_c", "routes=[through]", "participants.count=1")
    create_study(
        compose_protocol("utah2017_component", (*short, "order.block_length=1")), path, "small"
    )
    run_trials(path)
    return path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path) -> int:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        main()
    return int(end.value.code or 0)


def test_report_is_written_beside_the_study_and_again_the_same(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], study: Path
) -> None:
    assert run(monkeypatch, "report", study) == 0
    page = study.with_suffix(".html")
    assert str(page) in capsys.readouterr().out
    first = page.read_bytes()
    assert run(monkeypatch, "report", study) == 0
    assert page.read_bytes() == first


def test_another_file_is_never_replaced(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    study: Path,
    tmp_path: Path,
) -> None:
    mine = tmp_path / "thesis.html"
    mine.write_text("<html>my own</html>", encoding="utf-8")
    assert run(monkeypatch, "report", study, "-o", mine) == 1
    assert "thesis.html" in capsys.readouterr().err
    assert mine.read_text(encoding="utf-8") == "<html>my own</html>"


def test_a_page_in_no_folder_is_refused_at_once(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    study: Path,
    tmp_path: Path,
) -> None:
    assert run(monkeypatch, "report", study, "-o", tmp_path / "none" / "page.html") == 1
    assert f"there is no folder {tmp_path / 'none'}" in capsys.readouterr().err


def test_an_arm_study_that_lies_beside_is_named_and_not_used(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], study: Path
) -> None:
    beside = study.with_name("utah2017_arm_stiffness.db")
    beside.touch()
    assert run(monkeypatch, "report", study) == 0
    assert f"--arm-study {beside}" in capsys.readouterr().err
    assert "No arm-stiffness study was given" in study.with_suffix(".html").read_text("utf-8")
    beside.unlink()


def test_numbers_come_as_json(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], study: Path
) -> None:
    assert run(monkeypatch, "report", study, "--json") == 0
    numbers = json.loads(capsys.readouterr().out)
    assert numbers["study"]["kind"] == "virtual"
    assert numbers["study"]["participants"] == 1


def test_a_study_without_arms_is_no_arm_study(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], study: Path
) -> None:
    assert run(monkeypatch, "report", study, "--arm-study", study) == 1
    assert "arm_stiffness_quantile" in capsys.readouterr().err
