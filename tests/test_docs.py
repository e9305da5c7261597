"""What the documentation says is true: every command is in it, every command in it runs."""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parent.parent
PAGES = sorted([ROOT / "README.md", *ROOT.glob("CONTRIBUTING.md"), *(ROOT / "docs").rglob("*.md")])
RUNNABLE = {"console", "python"}
NOT_RUNNABLE = {"text", "yaml", "sql", "json", "csv", "toml", ""}
MAY_STAY_UNRUN = re.compile(
    r"make |git clone |cd |\. \.venv/|python3? -m venv |pip install |omnistudy .*\.\./shared/data/"
    r"|omnistudy drive primitive_a --device keyboard$"
)

FENCE = re.compile(
    r"^(?:<!-- not run: (?P<reason>[^\n]+) -->\n)?```(?P<language>\w*)\n(?P<body>.*?)^```$",
    re.M | re.S,
)
HEREDOC = re.compile(r"<<-?\s*['\"]?(\w+)['\"]?")


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, its commands (or its code), and why it is not run."""

    language: str
    commands: tuple[str, ...]
    reason: str | None


def blocks(text: str) -> list[Block]:
    found = []
    for fence in FENCE.finditer(text):
        language, body = fence["language"], fence["body"]
        commands = tuple(_commands(body)) if language == "console" else (body,)
        found.append(Block(language, commands, fence["reason"]))
    return found


def _commands(body: str) -> list[str]:
    """Give the commands of a console block: `$ ` lines with what continues them."""
    commands: list[str] = []
    until: str | None = None
    continued = False
    for line in body.splitlines():
        if until is not None or continued:
            commands[-1] += "\n" + line
        elif line.startswith("$ "):
            commands.append(line[2:])
        else:
            continue
        if until is not None:
            until = None if line == until else until
            continue
        heredoc = HEREDOC.search(line)
        until = heredoc[1] if heredoc else None
        continued = line.endswith("\\")
    return commands


def script(page: list[Block]) -> str:
    """Give one bash script that does what the page says, in order."""
    lines = ["set -e"]
    for block in page:
        if block.reason is not None or block.language not in RUNNABLE:
            continue
        if block.language == "python":
            lines.append(f"python - <<'END_OF_BLOCK'\n{block.commands[0]}END_OF_BLOCK")
            continue
        lines.extend(block.commands)
    return "\n".join(lines) + "\n"


def _load_reference() -> ModuleType:
    path = ROOT / "docs" / "make_reference.py"
    specification = importlib.util.spec_from_file_location("make_reference", path)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def _page_parameters(wanted: Callable[[Block], bool]) -> list[object]:
    parameters = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        if any(wanted(block) for block in blocks(text)):
            parameters.append(pytest.param(page, id=str(page.relative_to(ROOT))))
    return parameters


def test_every_command_has_help_with_an_example() -> None:
    lacking = [
        path
        for path, command, _ in _load_reference().commands()
        if not command.help or (not hasattr(command, "commands") and path not in command.help)
    ]
    assert lacking == [], "commands whose help lacks an example that names them in full"


def test_command_reference_is_fresh() -> None:
    reference = _load_reference()
    assert reference.PAGE.read_text(encoding="utf-8") == reference.page(), (
        "stale: run `make reference`"
    )


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_blocks_say_what_they_are(page: Path) -> None:
    languages = {block.language for block in blocks(page.read_text(encoding="utf-8"))}
    assert languages <= RUNNABLE | NOT_RUNNABLE, "commands belong in ```console blocks with `$ `"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page: Path) -> None:
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
    targets = re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text)
    broken = [t for t in targets if "://" not in t and not (page.parent / t).exists()]
    assert broken == []


@pytest.mark.slow
@pytest.mark.parametrize(
    "page", _page_parameters(lambda b: b.reason is None and b.language in RUNNABLE)
)
def test_every_command_runs(page: Path, tmp_path: Path) -> None:
    binaries = Path(sys.executable).parent
    environment = {
        **{name: value for name, value in os.environ.items() if not name.startswith("OMNISTUDY")},
        "PATH": f"{binaries}{os.pathsep}{os.environ['PATH']}",
        "HOME": str(tmp_path),
        "OMNISTUDY_STUDIES": str(tmp_path / "studies"),
        "NO_COLOR": "1",
    }
    ran = subprocess.run(
        ["bash", "-x", "-c", script(blocks(page.read_text(encoding="utf-8")))],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        timeout=900,
    )
    assert ran.returncode == 0, f"{ran.stdout[-2000:]}\n{ran.stderr[-4000:]}"


@pytest.mark.parametrize("page", _page_parameters(lambda b: b.reason is not None))
def test_what_is_not_run_may_stay_so(
    page: Path, record_property: Callable[[str, object], None]
) -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for block in blocks(page.read_text(encoding="utf-8")):
        if block.reason is None:
            continue
        for command in block.commands:
            record_property("not run", f"`{command}` ({block.reason})")
            assert MAY_STAY_UNRUN.match(command), command
            if target := re.match(r"make ([a-z-]+)", command):
                assert re.search(rf"^{target[1]}:", makefile, re.M), f"no target {target[1]}"


def test_console_block_is_read_as_a_person_reads_it() -> None:
    text = (
        "```console\n$ cat > a <<'END'\nx: 1\n$ y\nEND\nshown\n$ ls \\\n  -l\nshown\n```\n"
        "<!-- not run: it takes hours -->\n```console\n$ make demo\n```\n"
    )
    first, second = blocks(text)
    assert first.commands == ("cat > a <<'END'\nx: 1\n$ y\nEND", "ls \\\n  -l")
    assert (second.commands, second.reason) == (("make demo",), "it takes hours")
    assert script([first, second]).endswith("END\nls \\\n  -l\n")
