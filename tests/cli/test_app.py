"""What every command has in common: quick help, clear mistakes, exit statuses, completion."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest
import typer

from omnistudy.cli import app as cli
from omnistudy.errors import OmnistudyError

OMNISTUDY = str(Path(sys.executable).parent / "omnistudy")


def _verbs() -> typer.Typer:
    verbs = typer.Typer()

    @verbs.command()
    def refuse() -> None:
        raise OmnistudyError("no study 'x': create it with `omnistudy study create x`")

    @verbs.command()
    def break_down() -> None:
        raise ValueError("two\nlines")

    @verbs.command()
    def interrupt() -> None:
        raise KeyboardInterrupt

    @verbs.command()
    def conf() -> None:
        print(os.environ["OMNISTUDY_CONF"])

    return verbs


@pytest.fixture(autouse=True)
def trouble(monkeypatch: pytest.MonkeyPatch) -> None:
    """Add a noun whose verbs go wrong in every way."""
    module = ModuleType("omnistudy.cli.trouble")
    module.app = _verbs()
    monkeypatch.setitem(sys.modules, "omnistudy.cli.trouble", module)
    monkeypatch.setitem(cli.NOUNS, "trouble", cli.Noun("Everything that can go wrong."))
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)


def _run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int | None:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *arguments])
    with pytest.raises(SystemExit) as end:
        cli.main()
    assert end.value.code is None or isinstance(end.value.code, int)
    return end.value.code


def test_help_names_every_noun_and_imports_none() -> None:
    ran = subprocess.run(
        [
            sys.executable,
            "-c",
            "import atexit, sys; from omnistudy.cli.app import main\n"
            "atexit.register(lambda: print(*sorted(sys.modules), file=sys.stderr))\n"
            "sys.argv = ['omnistudy', '--help']; main()",
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    shown = {line.split()[0] for line in ran.stdout.split("Commands:")[1].splitlines() if line}
    assert shown == set(cli.NOUNS) - {"trouble"}
    imported = set(ran.stderr.split())
    assert imported & {"numpy", "pydantic", "rich", "hydra", "sqlalchemy", "pybullet"} == set()
    assert imported & {f"omnistudy.cli.{noun}" for noun in cli.NOUNS} == set()


def test_mistake_is_one_sentence_and_status_1(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert _run(monkeypatch, "trouble", "refuse") == 1
    shown = capsys.readouterr()
    assert shown.err == "error: no study 'x': create it with `omnistudy study create x`\n"
    assert shown.out == ""


def test_bug_is_one_sentence_that_names_debug(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert _run(monkeypatch, "trouble", "break-down") == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "ValueError: two lines" in said
    assert "--debug" in said


@pytest.mark.parametrize(
    "line", [["--debug", "trouble", "break-down"], ["trouble", "break-down", "--debug"]]
)
def test_debug_shows_the_trace(monkeypatch: pytest.MonkeyPatch, line: list[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["omnistudy", *line])
    with pytest.raises(ValueError, match="two\nlines"):
        cli.main()


def test_interrupt_is_one_line_and_status_130(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert _run(monkeypatch, "trouble", "interrupt") == 130
    assert capsys.readouterr().err.strip().startswith("stopped: what was finished is stored")


@pytest.mark.parametrize(
    ("line", "nearest"),
    [(["troubel"], "'trouble'"), (["trouble", "refues"], "'refuse'"), (["--debg"], "--debug")],
)
def test_wrong_usage_is_status_2_and_names_the_nearest(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    line: list[str],
    nearest: str,
) -> None:
    assert _run(monkeypatch, *line) == 2
    assert nearest in capsys.readouterr().err


def test_conf_names_the_labs_folder(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setenv("OMNISTUDY_CONF", str(tmp_path.parent))
    assert _run(monkeypatch, "--conf", str(tmp_path), "trouble", "conf") == 0
    assert capsys.readouterr().out.strip() == str(tmp_path)


def test_conf_that_is_no_folder_is_wrong_usage(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert _run(monkeypatch, "--conf", str(tmp_path / "none"), "trouble", "conf") == 2
    assert "does not exist" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("typed", "offered"), [("trou", "trouble"), ("trouble ref", "refuse"), ("--vers", "--version")]
)
def test_shell_completes_nouns_verbs_and_options(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    typed: str,
    offered: str,
) -> None:
    words = f"omnistudy {typed}"
    monkeypatch.setenv("_OMNISTUDY_COMPLETE", "complete_bash")
    monkeypatch.setenv("COMP_WORDS", words)
    monkeypatch.setenv("COMP_CWORD", str(words.count(" ")))
    _run(monkeypatch)
    assert capsys.readouterr().out.split() == [offered]


def test_version_is_that_of_the_package() -> None:
    from importlib.metadata import version

    ran = subprocess.run([OMNISTUDY, "--version"], capture_output=True, text=True, check=True)
    assert ran.stdout == f"omnistudy {version('omnistudy')}\n"


@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize("option", ["--help", "--version"])
def test_reader_that_leaves_early_meets_no_trace(option: str, unbuffered: str) -> None:
    read, write = os.pipe()
    os.close(read)
    ran = subprocess.run(
        [OMNISTUDY, option],
        stdout=write,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": unbuffered},
    )
    os.close(write)
    assert ran.stderr == ""
